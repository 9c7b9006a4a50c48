// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace selion {

enum class MachineKind { car, differential };

/// One machine. Lengths are from the rear axle's centre (for a differential one the wheels' axle), the point
/// whose path is planned. Only mounted tools are modelled.
struct Machine {
  std::string preset = "robot-3m";  ///< the preset that the other values started from
  MachineKind kind = MachineKind::car;
  double working_width_m = 3;
  double tool_x_m = -1;  ///< place of the tool line, ahead positive
  double body_width_m = 2;
  double front_m = 2.4;  ///< the body's reach ahead, > 0
  double rear_m = 1.2;   ///< the body's reach behind (tool included), > 0
  double wheelbase_m = 1.8;
  double track_m = 1.5;
  double max_steer_deg = 45;
  double max_steer_rate_deg_s = 45;
  std::optional<double> min_turn_radius_m;  ///< instead of steering angle
  double max_speed_mps = 3;
  double work_speed_mps = 1.5;
  double turn_speed_mps = 1;
  double max_accel_mps2 = 0.5;
  double max_brake_mps2 = 0.5;
  double max_lateral_mps2 = 1;
  double mass_kg = 1500;
  bool may_reverse = true;
  double safety_radius_m = 2;
  double safety_gap_m = 0.3;
  double tyre_width_m = 0.3;
  double clearance_m = 0.6;
  std::optional<double> min_work_radius_m;  ///< tool down; the turning radius where absent
  double run_in_m = 0;
  double tool_raise_s = 0;
  double tool_lower_s = 0;
  bool may_pivot = false;
  double guidance_sd_m = 0.025;

  friend bool operator==(const Machine&, const Machine&) = default;
};

/// Curvature that the steering reaches, 1/m: tan(max_steer)/wheelbase (Cariou et al. 2020, eq. 16), or
/// 1/min_turn_radius.
double max_curvature_per_m(const Machine& machine);

/// Sharpness (change of curvature along the path, 1/m2) that the steering rate allows at `speed_mps` (Cariou
/// et al. 2020, eq. 20: what turns are planned with). It is the exact limit where the path is straight, to
/// 1e-4, and safe where it bends.
double max_sharpness_per_m2(const Machine& machine, double speed_mps);

/// Length between the parts that steer, m: the wheelbase, or the track of a differential machine.
double steering_base_m(const Machine& machine);

/// How fast the steering moves, rad/s, where the path has this curvature and sharpness: |sharpness| v L / (1
/// + (L curvature)^2), the derivative of the angle atan(L curvature) of eq. 16. A differential machine has no
/// steering angle: |sharpness| v track, at which the quotient of its sides' speeds changes.
double steering_rate_rad_s(const Machine& machine, double curvature_per_m, double sharpness_per_m2,
                           double speed_mps);

/// Fastest speed where the path has this curvature and sharpness: lateral acceleration, steering rate (exact,
/// see steering_rate_rad_s) and max_speed_mps.
double max_speed_mps(const Machine& machine, double curvature_per_m, double sharpness_per_m2);

/// @throws InputError naming the key, its value and what it must be.
void validate(const Machine& machine);

struct MachinePreset {
  std::string_view name;
  std::string_view about;
  Machine machine;
  double edge_margin_m;  ///< the defaults of the distances kept (a small robot on a test field keeps less)
  double obstacle_clearance_m;
};

/// The machines that ship with selion; the first one is assumed where none is given.
std::span<const MachinePreset> machine_presets();

}  // namespace selion
