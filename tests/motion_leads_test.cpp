// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>

#include "selion/core/angle.hpp"
#include "selion/motion/leads.hpp"

using namespace selion;

TEST_CASE("a lead ends where it shall, off it at its start, and is wide", "[motion]") {
  constexpr CurveLimits kLimits{0.27, 0.33};
  const Pose lane{{12, -7}, 0.8};
  int to_left = 0;
  for (const Path& lead : leads_onto(lane, kLimits)) {
    const Pose end = end_pose(lead);
    CHECK(distance_m(end.at, lane.at) < 1e-9);
    CHECK(std::abs(wrapped(end.heading_rad - lane.heading_rad)) < 1e-9);
    const double aside_m = cross(unit(lane.heading_rad), start_pose(lead).at - lane.at);
    CHECK(std::abs(aside_m) > 0.1);
    to_left += aside_m > 0 ? 1 : 0;
    for (const Stretch& stretch : lead) {
      CHECK(stretch.gear == Gear::forward);
      CHECK(std::abs(end_of(stretch.curve).curvature_per_m) <= kLimits.curvature_per_m / 8 + 1e-12);
    }
  }
  CHECK(2 * to_left == static_cast<int>(leads_onto(lane, kLimits).size()));
}

TEST_CASE("leads off a pose start there", "[motion]") {
  const Pose lane{{3, 4}, -2};
  const std::vector<Path> leads = leads_off(lane, {0.27, 0.33});
  CHECK(leads.size() >= 6);
  for (const Path& lead : leads) CHECK(start_pose(lead) == lane);
}
