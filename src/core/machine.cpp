// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "selion/core/error.hpp"
#include "selion/core/units.hpp"

namespace selion {
namespace {

constexpr double kStep_m = 0.01;  // the step over which eq. 20 measures the change of curvature

/// A differential machine has no steering: its curvature can change as fast as its wheels' speeds can.
double wheelbase_for_steering_m(const Machine& machine) {
  return machine.kind == MachineKind::car ? machine.wheelbase_m : machine.track_m;
}

double steer_rate_rad_s(const Machine& machine) { return radians_of_degrees(machine.max_steer_rate_deg_s); }

struct Rule {
  const char* key;
  double value;
  double low;   // exclusive
  double high;  // inclusive
};

}  // namespace

double max_curvature_per_m(const Machine& machine) {
  if (machine.min_turn_radius_m) return 1 / *machine.min_turn_radius_m;
  return std::tan(radians_of_degrees(machine.max_steer_deg)) / machine.wheelbase_m;
}

double max_sharpness_per_m2(const Machine& machine, double speed_mps) {
  const double angle = kStep_m * steer_rate_rad_s(machine) / speed_mps;
  const double safe = std::min(angle, 1.0);  // slower than 1 cm a radian: no limit that matters
  return std::tan(safe) / (kStep_m * wheelbase_for_steering_m(machine));
}

double max_speed_mps(const Machine& machine, double curvature_per_m, double sharpness_per_m2) {
  double speed = machine.max_speed_mps;
  if (curvature_per_m != 0) speed = std::min(speed, std::sqrt(machine.max_lateral_mps2 / std::abs(curvature_per_m)));
  if (sharpness_per_m2 != 0) {
    const double angle = std::atan(kStep_m * wheelbase_for_steering_m(machine) * std::abs(sharpness_per_m2));
    speed = std::min(speed, kStep_m * steer_rate_rad_s(machine) / angle);
  }
  return speed;
}

void validate(const Machine& m) {
  const double huge = 1e6;
  const auto rules = std::to_array<Rule>({
      {"working_width_m", m.working_width_m, 0.05, 100},
      {"body_width_m", m.body_width_m, 0, 100},
      {"front_m", m.front_m, 0, 100},
      {"rear_m", m.rear_m, 0, 100},
      {"tool_x_m", m.tool_x_m, -100.001, 100},
      {"wheelbase_m", m.wheelbase_m, 0.05, 100},
      {"track_m", m.track_m, 0, 100},
      {"max_steer_deg", m.max_steer_deg, 0, 89},
      {"max_steer_rate_deg_s", m.max_steer_rate_deg_s, 0, huge},
      {"min_turn_radius_m", m.min_turn_radius_m.value_or(1), 0.05, 1000},
      {"max_speed_mps", m.max_speed_mps, 0, 100},
      {"work_speed_mps", m.work_speed_mps, 0, m.max_speed_mps},
      {"turn_speed_mps", m.turn_speed_mps, 0, m.max_speed_mps},
      {"max_accel_mps2", m.max_accel_mps2, 0, 100},
      {"max_brake_mps2", m.max_brake_mps2, 0, 100},
      {"max_lateral_mps2", m.max_lateral_mps2, 0, 100},
      {"mass_kg", m.mass_kg, 0, huge},
      {"safety_radius_m", m.safety_radius_m, -1e-12, huge},
      {"safety_gap_m", m.safety_gap_m, -1e-12, huge},
      {"tyre_width_m", m.tyre_width_m, -1e-12, 10},
      {"clearance_m", m.clearance_m, -1e-12, 100},
      {"min_work_radius_m", m.min_work_radius_m.value_or(1), 0, huge},
      {"run_in_m", m.run_in_m, -1e-12, 1000},
      {"tool_raise_s", m.tool_raise_s, -1e-12, 600},
      {"tool_lower_s", m.tool_lower_s, -1e-12, 600},
      {"guidance_sd_m", m.guidance_sd_m, -1e-12, 10},
  });
  for (const Rule& rule : rules) {
    if (rule.value > rule.low && rule.value <= rule.high) continue;  // a NaN fails both
    throw InputError{"machine: " + std::string{rule.key} + " = " + std::to_string(rule.value) + " is out of range: it must be above " +
                     std::to_string(std::max(rule.low, 0.0) == 0 && rule.low > -1 ? 0.0 : rule.low) + " and at most " +
                     std::to_string(rule.high)};
  }
}

}  // namespace selion
