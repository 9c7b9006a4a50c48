// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kSlack_s = 5e-3;

const Driven* trajectory_of(const Case& plan, int block, int robot) {
  for (const Driven& driven : plan.drives)
    if (driven.record->block == block && driven.record->robot == robot) return &driven;
  return nullptr;
}

/// What is wrong with a wait for another robot; empty where that one comes by before it ends.
std::string trouble_of(const Case& plan, const Driven& driven, std::size_t i) {
  const PieceRecord& wait = driven.pieces[i].record();
  const std::string robot = "robot " + std::to_string(*wait.for_robot);
  if (*wait.for_robot == driven.record->robot) return " waits for itself";
  const Driven* other = trajectory_of(plan, driven.record->block, *wait.for_robot);
  if (other == nullptr) return " waits for " + robot + ", which does not drive in this block";
  const double station = *wait.until_station_m;
  if (!(station >= 0 && station <= other->whole_m()))
    return " waits for ever: " + robot + " drives " + shown(other->whole_m(), 1) + " m, not " +
           shown(station, 1) + " m";
  if (driven.moments.empty() || other->moments.empty()) return "";
  const double end = departure_s(driven, driven.begin_m[i]);
  const double passes = time_s(*other, station);
  if (passes <= end + kSlack_s) return "";
  return " ends at " + shown(end, 1) + " s; " + robot + " comes to " + shown(station, 1) + " m only at " +
         shown(passes, 1) + " s";
}

}  // namespace

void check_waits(Case& plan) {
  for (const Driven& driven : plan.drives)
    for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
      if (!driven.pieces[i].record().for_robot) continue;
      const std::string trouble = trouble_of(plan, driven, i);
      if (!trouble.empty())
        plan.findings.add("wait", driven.record->block, driven.pieces[i].spot(0).at, {},
                          piece_name(driven, i) + trouble);
    }
}

}  // namespace selion::verifying
