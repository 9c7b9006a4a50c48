// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/dead_ends.hpp"

#include <algorithm>
#include <numbers>

#include "selion/motion/leads.hpp"

namespace selion {
namespace {

template <class Fits>
bool turns_at(const Pose& pose, const Swings& swings, Fits fits) {
  constexpr double kTurn_rad = 2 * std::numbers::pi / 3;
  return fits(swing(pose, kTurn_rad, swings)) || fits(swing(pose, -kTurn_rad, swings));
}

/// Straight on or led off gently, and a turn by a third of a circle, as long or short and to either side as
/// it takes.
template <class Fits>
bool turns_off(const Pose& pose, const Swings& swings, Fits fits) {
  const double radius_m = 1 / swings.limits().curvature_per_m;
  for (const double on_m : {0.0, radius_m, 2 * radius_m, 4 * radius_m}) {
    const Pose begin{pose.at + on_m * unit(pose.heading_rad), pose.heading_rad};
    if (on_m > 0 && !fits(Path{{line(pose.at, begin.at), Gear::forward}})) break;
    if (turns_at(begin, swings, fits)) return true;
  }
  return std::ranges::any_of(leads_off(pose, swings.limits()), [&](const Path& lead) {
    return fits(lead) && turns_at(end_pose(lead), swings, fits);
  });
}

}  // namespace

bool has_way_in(const FreeSpace& space, const Footprint& footprint, const Swings& swings, const Pose& pose) {
  return turns_off({pose.at, pose.heading_rad + std::numbers::pi}, swings,
                   [&](const Path& path) { return fits(space, footprint, turned_round(path)); });
}

bool has_way_out(const FreeSpace& space, const Footprint& footprint, const Swings& swings, const Pose& pose) {
  return turns_off(pose, swings, [&](const Path& path) { return fits(space, footprint, path); });
}

}  // namespace selion
