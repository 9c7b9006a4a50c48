// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/dead_ends.hpp"

#include "parts.hpp"

namespace selion {

AxisExtent without_dead_ends(const Ground& ground, const Swath& way, AxisExtent fit) {
  constexpr double kStep_m = 1;
  if (ground.machine.may_reverse) return fit;
  const Point axis = (1 / distance_m(way.from, way.to)) * (way.to - way.from);
  const auto axle_at = [&](double s_m) {
    return Pose{way.from + (s_m - ground.machine.tool_x_m) * axis, heading_rad(axis)};
  };
  while (fit.high_m > fit.low_m &&
         !has_way_in(ground.space, ground.footprint, ground.swings, axle_at(fit.low_m)))
    fit.low_m += kStep_m;
  while (fit.high_m > fit.low_m &&
         !has_way_out(ground.space, ground.footprint, ground.swings, axle_at(fit.high_m)))
    fit.high_m -= kStep_m;
  return fit;
}

}  // namespace selion
