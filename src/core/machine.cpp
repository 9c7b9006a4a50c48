// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"

namespace selion {
namespace {

constexpr double kStep_m = 0.01;  // the step over which eq. 20 measures the change of curvature

double steer_rate_rad_s(const Machine& machine) { return radians_of_degrees(machine.max_steer_rate_deg_s); }

struct Rule {
  const char* key;
  double value;
  double low;
  double high;
  bool low_itself;                // may the value be `low`?
  const char* high_is = nullptr;  // the key that sets `high`
};

/// "0.3": at most six decimals, none that are zeros.
std::string short_text(double value) {
  if (!std::isfinite(value)) return "a number that is not finite";
  std::string text = fixed(value, 6);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void check(const Rule& rule) {
  const bool above = rule.low_itself ? rule.value >= rule.low : rule.value > rule.low;
  if (above && rule.value <= rule.high) return;  // a NaN fails both
  throw InputError{"machine." + std::string{rule.key} + " = " + short_text(rule.value) +
                   " is out of range: " + (rule.low_itself ? "from " : "above ") + short_text(rule.low) +
                   " to " + (rule.high_is == nullptr ? "" : std::string{rule.high_is} + " = ") +
                   short_text(rule.high)};
}

}  // namespace

double max_curvature_per_m(const Machine& machine) {
  if (machine.min_turn_radius_m) return 1 / *machine.min_turn_radius_m;
  return std::tan(radians_of_degrees(machine.max_steer_deg)) / machine.wheelbase_m;
}

double max_sharpness_per_m2(const Machine& machine, double speed_mps) {
  const double angle = kStep_m * steer_rate_rad_s(machine) / speed_mps;
  const double safe = std::min(angle, 1.0);  // slower than 1 cm a radian: no limit that matters
  return std::tan(safe) / (kStep_m * steering_base_m(machine));
}

double steering_base_m(const Machine& machine) {
  return machine.kind == MachineKind::car ? machine.wheelbase_m : machine.track_m;
}

double steering_rate_rad_s(const Machine& machine, double curvature_per_m, double sharpness_per_m2,
                           double speed_mps) {
  const double base = steering_base_m(machine);
  const double tangent = machine.kind == MachineKind::car ? base * curvature_per_m : 0;
  return std::abs(sharpness_per_m2) * speed_mps * base / (1 + tangent * tangent);
}

double max_speed_mps(const Machine& machine, double curvature_per_m, double sharpness_per_m2) {
  double speed = machine.max_speed_mps;
  if (curvature_per_m != 0)
    speed = std::min(speed, std::sqrt(machine.max_lateral_mps2 / std::abs(curvature_per_m)));
  if (sharpness_per_m2 != 0)
    speed = std::min(speed, radians_of_degrees(machine.max_steer_rate_deg_s) /
                                steering_rate_rad_s(machine, curvature_per_m, sharpness_per_m2, 1));
  return speed;
}

void validate(const Machine& m) {
  const double huge = 1e6;
  const auto rules = std::to_array<Rule>({
      {"working_width_m", m.working_width_m, 0.05, 100, true},
      {"body_width_m", m.body_width_m, 0, 100, false},
      {"front_m", m.front_m, 0, 100, false},
      {"rear_m", m.rear_m, 0, 100, false},
      {"tool_x_m", m.tool_x_m, -100, 100, true},
      {"wheelbase_m", m.wheelbase_m, 0.05, 100, true},
      {"track_m", m.track_m, 0, 100, false},
      {"max_steer_deg", m.max_steer_deg, 0, 89, false},
      {"max_steer_rate_deg_s", m.max_steer_rate_deg_s, 0, huge, false},
      {"min_turn_radius_m", m.min_turn_radius_m.value_or(1), 0.05, 1000, true},
      {"max_speed_mps", m.max_speed_mps, 0, 100, false},
      {"work_speed_mps", m.work_speed_mps, 0, m.max_speed_mps, false, "max_speed_mps"},
      {"turn_speed_mps", m.turn_speed_mps, 0, m.max_speed_mps, false, "max_speed_mps"},
      {"max_accel_mps2", m.max_accel_mps2, 0, 100, false},
      {"max_brake_mps2", m.max_brake_mps2, 0, 100, false},
      {"max_lateral_mps2", m.max_lateral_mps2, 0, 100, false},
      {"mass_kg", m.mass_kg, 0, huge, false},
      {"safety_radius_m", m.safety_radius_m, 0, huge, true},
      {"safety_gap_m", m.safety_gap_m, 0, huge, true},
      {"tyre_width_m", m.tyre_width_m, 0, 10, true},
      {"clearance_m", m.clearance_m, 0, 100, true},
      {"min_work_radius_m", m.min_work_radius_m.value_or(1), 0, huge, false},
      {"run_in_m", m.run_in_m, 0, 1000, true},
      {"tool_raise_s", m.tool_raise_s, 0, 600, true},
      {"tool_lower_s", m.tool_lower_s, 0, 600, true},
      {"guidance_sd_m", m.guidance_sd_m, 0, 10, true},
  });
  for (const Rule& rule : rules) check(rule);
  constexpr double kWidest_m = 1000;  // as of min_turn_radius_m
  if (const double radius_m = 1 / max_curvature_per_m(m); radius_m > kWidest_m)
    throw InputError{"machine.max_steer_deg = " + short_text(m.max_steer_deg) + " makes a tightest turn of " +
                     short_text(std::round(radius_m)) + " m radius; at most " + short_text(kWidest_m) +
                     " are planned with"};
}

}  // namespace selion
