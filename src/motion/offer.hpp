// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "words.hpp"

namespace selion {

constexpr double kInLine = 1e-9;  // m, rad: a goal this near to straight ahead is driven to straight

/// A pair of poses, and the second as seen from the first: x ahead, y left, heading in (-pi, pi].
struct View {
  View(const Pose& from_pose, const Pose& to_pose);

  Pose from;
  Pose to;
  Point ahead;  ///< unit(from.heading_rad)
  Pose goal;
};

/// The part of [0, 2 pi) that differs from `angle_rad` by whole turns.
double whole_turns_off(double angle_rad);

/// The word drawn from `view.from`, if it ends at `view.to` and keeps the limits (1e-9 each; what is left are
/// roundings of 1e-12 but for straights).
std::optional<Path> drawn_to(const Word& word, const View& view, const Swings& swings);

/// A U-turn between swaths that end at unequal places: the shorter one is driven on.
struct UTurn {
  double before_m = 0;    ///< straight before the turn
  double after_m = 0;     ///< straight after it
  Pose goal;              ///< of the turn between, seen from its start
  bool opposite = false;  ///< the goal's heading is pi but for rounding
};
/// Empty unless the goal's heading, seen from the start, is opposite within 1e-6 rad.
std::optional<UTurn> u_turn(Pose goal);

}  // namespace selion
