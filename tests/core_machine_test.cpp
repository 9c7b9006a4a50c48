// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

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
  CHECK_NOTHROW(validate(with(&Machine::safety_radius_m, 0)));
}
