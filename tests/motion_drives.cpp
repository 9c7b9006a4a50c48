// SPDX-License-Identifier: GPL-3.0-or-later
#include "motion_drives.hpp"
#include "test.hpp"

#include <random>

namespace selion {

std::vector<Leg> winding_legs(unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> share{0, 1};
  std::vector<Leg> legs;
  Curve curve{{1, 2}, 0.3, 0, 0, 0};
  for (int i = 0; i < 40; ++i) {
    const bool steady = i % 3 == 0;
    const double next = steady ? curve.curvature_per_m : 0.5 * (2 * share(random) - 1) * (i % 5 == 0 ? 0 : 1);
    curve.length_m = steady ? 5 * share(random) : 0.02 + 4 * share(random) * share(random);
    curve.sharpness_per_m2 = (next - curve.curvature_per_m) / curve.length_m;
    legs.push_back({{curve}, 0.3 + 5.7 * share(random), i % 2 == 0, 0});
    const CurveState end = end_of(curve);
    curve = {end.at, end.heading_rad, next, 0, 0};
  }
  return legs;
}

std::vector<Machine> limited_machines() {
  Machine fast;
  fast.max_speed_mps = 6;
  fast.max_accel_mps2 = 2;
  fast.max_brake_mps2 = 3;
  Machine slow_steering = fast;
  slow_steering.max_steer_rate_deg_s = 12;
  Machine slippery = fast;
  slippery.max_lateral_mps2 = 0.4;
  slippery.max_steer_rate_deg_s = 180;
  Machine skid = fast;
  skid.kind = MachineKind::differential;
  skid.min_turn_radius_m = 1.0;
  Machine heavy = slow_steering;
  heavy.max_accel_mps2 = 0.3;
  heavy.max_brake_mps2 = 0.2;
  heavy.max_lateral_mps2 = 0.6;
  return {fast, slow_steering, slippery, skid, heavy};
}

void check_within(const LimitUse& use) {
  const auto check = [](const char* name, const Use& one) {
    CAPTURE(name, one.leg, one.s_m);
    CHECK(one.share <= 1 + 1e-9);
  };
  check("curvature", use.curvature);
  check("steering rate", use.steering_rate);
  check("speed", use.speed);
  check("lateral acceleration", use.lateral);
  check("acceleration", use.acceleration);
  check("braking", use.braking);
}

}  // namespace selion
