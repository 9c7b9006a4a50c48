// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <limits>

#include "selion/core/error.hpp"
#include "selion/core/machine.hpp"

using namespace selion;
using Catch::Contains;

TEST_CASE("every preset is a machine that can be", "[core]") {
  for (const MachinePreset& preset : machine_presets()) {
    CAPTURE(preset.name);
    CHECK_NOTHROW(validate(preset.machine));
    CHECK(preset.machine.preset == preset.name);
  }
  CHECK(machine_presets().front().machine == Machine{});
}

namespace {

Machine with(double Machine::*key, double value) {
  Machine machine;
  machine.*key = value;
  return machine;
}

}  // namespace

TEST_CASE("a machine's value out of range is named with the range", "[core]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(validate(with(&Machine::working_width_m, 0.01)),
                    "machine.working_width_m = 0.01 is out of range: from 0.05 to 100");
  CHECK_THROWS_WITH(validate(with(&Machine::mass_kg, 0)),
                    "machine.mass_kg = 0 is out of range: above 0 to 1000000");
  CHECK_THROWS_WITH(validate(with(&Machine::work_speed_mps, 5)), Contains("above 0 to max_speed_mps = 3"));
  CHECK_THROWS_WITH(validate(with(&Machine::front_m, nan)),
                    Contains("machine.front_m = a number that is not"));
  CHECK_THROWS_WITH(validate(with(&Machine::max_steer_deg, 0.001)),
                    Contains("machine.max_steer_deg = 0.001 makes a tightest turn of") &&
                        Contains("m radius; at most 1000"));
  CHECK_NOTHROW(validate(with(&Machine::safety_radius_m, 0)));
}

TEST_CASE("the steering rate is the derivative of the steering angle in time", "[core]") {
  const Machine m;  // a car
  const double k = GENERATE(-0.5, 0.0, 0.3);
  const double sharpness = 0.4, speed = 1.3, dt = 1e-5;
  const double step = sharpness * speed * dt;
  const double rate =
      (std::atan(m.wheelbase_m * (k + step)) - std::atan(m.wheelbase_m * (k - step))) / (2 * dt);
  CHECK(steering_rate_rad_s(m, k, -sharpness, speed) == Approx(rate).epsilon(1e-8));
}

TEST_CASE("the fastest speed is the one at which a limit is reached", "[core]") {
  Machine m;
  m.kind = GENERATE(MachineKind::car, MachineKind::differential);
  m.max_speed_mps = 100;
  const double k = 0.4, sharpness = 0.9;
  const double curved = max_speed_mps(m, k, 0);
  CHECK(curved * curved * k == Approx(m.max_lateral_mps2));
  const double steered = max_speed_mps(m, 0.001, sharpness);
  CHECK(steering_rate_rad_s(m, 0.001, sharpness, steered) == Approx(m.max_steer_rate_deg_s * 0.0174532925));
  CHECK(max_speed_mps(m, 0, 0) == 100);
  // eq. 20 measures over 1 cm of path: it is the exact limit of a straight path to 1e-4
  CHECK(max_speed_mps(m, 0, max_sharpness_per_m2(m, 1)) == Approx(1).epsilon(1e-4));
}
