// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/standing.hpp"

#include <algorithm>
#include <cmath>

#include "selion/core/units.hpp"

namespace selion {
namespace {

/// Of the front wheels, left positive: in reverse the path bends to the other side of them.
double steering_rad(const Machine& machine, const Stretch& stretch, double s_m) {
  const double curvature = stretch.curve.curvature_per_m + stretch.curve.sharpness_per_m2 * s_m;
  return std::atan(machine.wheelbase_m * curvature * static_cast<double>(stretch.gear));
}

}  // namespace

Pivot pivot_of(const Machine& machine, double angle_rad) {
  const double way_m = scrub_m(machine, angle_rad);
  if (way_m == 0) return {};
  const double a = machine.max_accel_mps2;
  const double b = machine.max_brake_mps2;
  const double speed = std::min(machine.turn_speed_mps, std::sqrt(2 * way_m * a * b / (a + b)));
  const double gain_m = speed * speed / 2 / a;
  const double brake_m = speed * speed / 2 / b;
  return {speed / a, std::max(0.0, way_m - gain_m - brake_m) / speed, speed / b, gain_m / way_m,
          1 - brake_m / way_m};
}

double pivot_s(const Machine& machine, double angle_rad) { return pivot_of(machine, angle_rad).time_s(); }

double scrub_m(const Machine& machine, double angle_rad) { return machine.track_m / 2 * std::abs(angle_rad); }

double steering_s(const Machine& machine, const Stretch& before, const Stretch& after) {
  constexpr double kSame_rad = 1e-6;  // what rounding leaves of equal curvatures
  if (machine.kind == MachineKind::differential) return 0;
  const double by_rad =
      std::abs(steering_rad(machine, after, 0) - steering_rad(machine, before, before.curve.length_m));
  return by_rad < kSame_rad ? 0 : by_rad / radians_of_degrees(machine.max_steer_rate_deg_s);
}

Stretch standing_after(const Stretch& stretch) {
  const CurveState end = end_of(stretch.curve);
  return {{end.at, end.heading_rad + stretch.pivot_rad, end.curvature_per_m, 0, 0}, stretch.gear};
}

}  // namespace selion
