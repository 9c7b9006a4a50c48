// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/leads.hpp"

#include <numbers>

namespace selion {

std::vector<Path> leads_off(const Pose& from, const CurveLimits& limits) {
  struct Kind {
    double wider;
    double turn_rad;
  };
  std::vector<Path> leads;
  for (const auto& [wider, turn_rad] : {Kind{8, 0.3}, Kind{16, 0.2}, Kind{32, 0.1}}) {
    const Swings gentle{widened(limits, wider)};
    for (const double turn : {turn_rad, -turn_rad}) leads.push_back(swing(from, turn, gentle));
  }
  return leads;
}

std::vector<Path> leads_onto(const Pose& to, const CurveLimits& limits) {
  std::vector<Path> leads = leads_off({to.at, to.heading_rad + std::numbers::pi}, limits);
  for (Path& lead : leads) lead = turned_round(lead);
  return leads;
}

}  // namespace selion
