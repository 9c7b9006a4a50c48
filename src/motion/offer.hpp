// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "swing.hpp"

namespace selion {

/// `to` as seen from `from`: x ahead, y left, heading in (-pi, pi].
Pose seen_from(const Pose& from, const Pose& to);

/// The part of [0, 2 pi) that differs from `angle_rad` by whole turns.
double whole_turns_off(double angle_rad);

/// Adds what was drawn to `paths` if it ends straight at `to` and keeps the limits (1e-9 each).
void offer(std::vector<Path>& paths, Drawn drawn, const Pose& to, const CurveLimits& limits);

/// A U-turn between swaths that end at unequal places: the shorter one is driven on.
struct UTurn {
  double before_m = 0;  ///< straight before the turn
  double after_m = 0;   ///< straight after it
  Pose goal;            ///< of the turn between, seen from its start
};
/// Empty unless the headings are opposite within 1e-6 rad.
std::optional<UTurn> u_turn(const Pose& from, const Pose& to);

}  // namespace selion
