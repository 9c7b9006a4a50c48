// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <numbers>

#include "parts.hpp"

namespace selion {
namespace {

/// A turn this much longer than the shortest is taken where that saves depth; longer ones loop over the
/// swaths.
constexpr double kNotMuchLonger = 1.2;

double farthest_x_m(const Footprint& f, const Pose& pose) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Point corner : {Point{f.front_m, f.half_body_m}, Point{f.front_m, -f.half_body_m},
                             Point{-f.rear_m, f.half_body_m}, Point{-f.rear_m, -f.half_body_m},
                             Point{f.tool_x_m, f.half_tool_m}, Point{f.tool_x_m, -f.half_tool_m}})
    most = std::max(most, placed(pose, corner).x_m);
  return most;
}

}  // namespace

double turn_depth_m(const Machine& machine, double spacing_m) {
  const Footprint footprint = footprint_of(machine);
  const Pose out{{-machine.tool_x_m, 0}, 0};
  const Pose back{{machine.tool_x_m + machine.run_in_m, spacing_m}, std::numbers::pi};
  const Swings swings{limits_at(machine, machine.turn_speed_mps)};
  Connections turns{out, back, swings};
  double least = std::numeric_limits<double>::infinity();
  double longest = least;
  while (const auto turn = turns.next()) {
    if (length_m(*turn) > longest) break;
    longest = std::min(longest, kNotMuchLonger * length_m(*turn));
    double depth = 0;
    for (const Pose& pose : poses(*turn, 0.1)) depth = std::max(depth, farthest_x_m(footprint, pose));
    least = std::min(least, depth);
  }
  return least;
}

}  // namespace selion
