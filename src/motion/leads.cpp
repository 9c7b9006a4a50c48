// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/leads.hpp"

#include <numbers>

namespace selion {

std::vector<Path> leads_off(const Pose& from, const CurveLimits& limits) {
  std::vector<Path> leads;
  for (const double wider : {8.0, 16.0, 32.0}) {
    const Swings gentle{{limits.curvature_per_m / wider, limits.sharpness_per_m2 / (wider * wider)}};
    for (const double turn_rad : {0.1, -0.1, 0.2, -0.2, 0.3, -0.3})
      leads.push_back(swing(from, turn_rad, gentle));
  }
  return leads;
}

std::vector<Path> leads_onto(const Pose& to, const CurveLimits& limits) {
  std::vector<Path> leads = leads_off({to.at, to.heading_rad + std::numbers::pi}, limits);
  for (Path& lead : leads) lead = turned_round(lead);
  return leads;
}

}  // namespace selion
