// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "selion/core/machine.hpp"

namespace selion {
namespace {

// A 3 m field robot of the usual kind: four wheels, front steering, tool mounted behind the rear axle.
Machine robot_3m() { return Machine{}; }

// Cariou et al. 2020, section III and table I: 500 kg, L = 1.2 m, 30 degrees, 45 degrees/s, turns at 2 m/s, 1
// m wide. With
// --max-steer 18 it is the fleet's virtual robot of n = 4: K = tan(18 deg)/1.2 = .271, g = tan(.01 w/v)/(.01
// L) = .327.
Machine p3() {
  Machine m;
  m.preset = "p3";
  m.working_width_m = 1;
  m.tool_x_m = 0;
  m.body_width_m = 0.9;
  m.front_m = 1.5;
  m.rear_m = 0.4;
  m.wheelbase_m = 1.2;
  m.track_m = 0.7;
  m.max_steer_deg = 30;
  m.max_steer_rate_deg_s = 45;
  m.max_speed_mps = 3.5;
  m.work_speed_mps = 2;
  m.turn_speed_mps = 2;
  m.max_accel_mps2 = 1;
  m.max_brake_mps2 = 1;
  m.max_lateral_mps2 = 3;
  m.mass_kg = 500;
  m.safety_radius_m = 1;
  m.tyre_width_m = 0.2;
  return m;
}

// Clearpath Husky A200 data sheet: 990 x 670 mm, 50 kg, 1 m/s, skid steer; wheels' centre taken as the axle.
Machine husky() {
  Machine m;
  m.preset = "husky";
  m.kind = MachineKind::differential;
  m.working_width_m = 0.75;
  m.tool_x_m = 0;
  m.body_width_m = 0.67;
  m.front_m = 0.5;
  m.rear_m = 0.5;
  m.wheelbase_m = 0.512;
  m.track_m = 0.555;
  m.min_turn_radius_m = 0.5;
  m.max_speed_mps = 1;
  m.work_speed_mps = 0.8;
  m.turn_speed_mps = 0.4;
  m.max_lateral_mps2 = 0.5;
  m.mass_kg = 50;
  m.safety_radius_m = 0.7;
  m.tyre_width_m = 0.13;
  m.clearance_m = 0.13;
  m.may_pivot = true;
  return m;
}

// farm-ng Amiga, wide track: straddles one bed, four driven wheels, differential.
Machine amiga() {
  Machine m;
  m.preset = "amiga";
  m.kind = MachineKind::differential;
  m.working_width_m = 1.5;
  m.tool_x_m = 0;
  m.body_width_m = 1.75;
  m.front_m = 0.95;
  m.rear_m = 0.95;
  m.wheelbase_m = 1.2;
  m.track_m = 1.5;
  m.min_turn_radius_m = 1;
  m.max_speed_mps = 2;
  m.work_speed_mps = 1;
  m.turn_speed_mps = 0.6;
  m.max_lateral_mps2 = 0.5;
  m.mass_kg = 270;
  m.safety_radius_m = 1.3;
  m.tyre_width_m = 0.15;
  m.clearance_m = 0.6;
  m.may_pivot = true;
  return m;
}

Machine tractor(const char* name, double width_m) {
  Machine m;
  m.preset = name;
  m.working_width_m = width_m;
  m.tool_x_m = -1.8;
  m.body_width_m = 2.5;
  m.front_m = 4.2;
  m.rear_m = 2.4;
  m.wheelbase_m = 2.8;
  m.track_m = 1.8;
  m.max_steer_deg = 35;
  m.max_steer_rate_deg_s = 25;
  m.max_speed_mps = 4;
  m.work_speed_mps = 2.5;
  m.turn_speed_mps = 1.5;
  m.max_accel_mps2 = 0.5;
  m.max_brake_mps2 = 1;
  m.max_lateral_mps2 = 1.5;
  m.mass_kg = 9000;
  m.safety_radius_m = 4;
  m.tyre_width_m = 0.4;
  m.clearance_m = 0.5;
  return m;
}

Machine tractor_12m() {
  Machine m = tractor("tractor-12m", 12);
  m.wheelbase_m = 3;
  m.front_m = 4.5;
  m.tool_x_m = -2.2;
  m.rear_m = 3;
  m.mass_kg = 14000;
  m.safety_radius_m = 7;
  return m;
}

const auto kPresets = std::to_array<MachinePreset>({
    {"robot-3m", "a 3 m field robot, front steering, tool behind the axle", robot_3m(), 0.3, 0.5},
    {"p3", "the robot of Cariou et al. 2020: 500 kg, 1 m wide, wheelbase 1.2 m", p3(), 0.05, 0.05},
    {"husky", "Clearpath Husky A200, 0.75 m wide, skid steer", husky(), 0.3, 0.5},
    {"amiga", "farm-ng Amiga over a 1.5 m bed, differential", amiga(), 0.3, 0.5},
    {"tractor-6m", "a 9 t tractor with a 6 m mounted implement", tractor("tractor-6m", 6), 0.3, 0.5},
    {"tractor-12m", "a 14 t tractor with a 12 m mounted implement", tractor_12m(), 0.3, 0.5},
});

}  // namespace

std::span<const MachinePreset> machine_presets() { return kPresets; }

}  // namespace selion
