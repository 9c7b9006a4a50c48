// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "swing.hpp"

namespace selion {

/// Swing, straight, swing. Deflections are signed.
struct SwingLineSwing {
  double first_rad = 0;
  double line_m = 0;
  double second_rad = 0;
};

/// All that reach `goal` (seen from the start); a side is 1 for left, -1 for right.
std::vector<SwingLineSwing> swing_line_swings(const Pose& goal, int first_side, int second_side,
                                              const Swings& swings);

/// Three swings in turn to the side `side`, to the other and to `side` again; signed.
using ThreeSwings = std::array<double, 3>;

/// Those that reach `goal`, found from the swings of full curvature and of plain Dubins curves.
std::vector<ThreeSwings> three_swings(const Pose& goal, int side, const Swings& swings);

/// `start` brought to the goal by Newton steps; empty if it does not get there.
std::optional<ThreeSwings> polished(const ThreeSwings& start, const Pose& goal, const Swings& swings);

void draw_swings(Drawn& drawn, const ThreeSwings& deflections, const Swings& swings);

}  // namespace selion
