// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <numbers>

#include "selion/motion/dead_ends.hpp"

using namespace selion;

namespace {

const Swings kSwings{{0.27, 0.33}};
constexpr Footprint kBody{2.4, 0.6, 2, 0, 2};
constexpr double kPi = std::numbers::pi;

FreeSpace square(double side_m) {
  return free_space({{{0, 0}, {side_m, 0}, {side_m, side_m}, {0, side_m}}, {}}, kBody);
}

}  // namespace

TEST_CASE("in the middle of a field there is a way in and out", "[motion]") {
  const FreeSpace space = square(60);
  const double heading = GENERATE(0.0, 1.0, 2.5, -1.5);
  CHECK(has_way_in(space, kBody, kSwings, {{30, 30}, heading}));
  CHECK(has_way_out(space, kBody, kSwings, {{30, 30}, heading}));
}

TEST_CASE("with the front at the border there is no way out, with the back at it no way in", "[motion]") {
  const FreeSpace space = square(60);
  const Pose at_border{{57, 30}, 0};
  REQUIRE(fits(space, kBody, at_border));
  CHECK_FALSE(has_way_out(space, kBody, kSwings, at_border));
  CHECK(has_way_in(space, kBody, kSwings, at_border));
  const Pose from_border{{59, 30}, kPi};
  REQUIRE(fits(space, kBody, from_border));
  CHECK(has_way_out(space, kBody, kSwings, from_border));
  CHECK_FALSE(has_way_in(space, kBody, kSwings, from_border));
}
