// SPDX-License-Identifier: GPL-3.0-or-later
#include "connect.hpp"

#include <algorithm>
#include <cmath>

#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr double kCostStep_m = 3;

/// Longer than this, a single turn is no turn any more but a wander over the field.
double longest_turn_m(const Terrain& terrain, const Pose& from, const Pose& to) {
  return 20 / terrain.limits.curvature_per_m + 2 * distance_m(from.at, to.at);
}

/// Nothing, or straight on, where the goal lies there but for a tenth of what joints may miss: swings to mend
/// that would be crumbs.
std::optional<Path> straight_on(const Pose& from, const Pose& to) {
  constexpr double kMiss = 1e-7;  // m, rad
  const Point way = to.at - from.at;
  const Point along = unit(from.heading_rad);
  const double ahead_m = dot(way, along);
  const bool in_line =
      std::abs(cross(along, way)) < kMiss && std::abs(wrapped(to.heading_rad - from.heading_rad)) < kMiss;
  if (!in_line || ahead_m < -kMiss) return std::nullopt;
  if (ahead_m < kMiss) return Path{};
  return Path{{{from.at, from.heading_rad, 0, 0, ahead_m}, Gear::forward}};
}

}  // namespace

double cost_m(const Terrain& terrain, const Path& path) {
  double cost = 0;
  Gear last = path.empty() ? Gear::forward : path.front().gear;
  for (const Stretch& stretch : path) {
    const double length = stretch.curve.length_m;
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kCostStep_m)));
    int over = 0;
    for (int i = 0; i < steps; ++i)
      if (terrain.mainland.holds(state_at(stretch.curve, length * (i + 0.5) / steps).at)) ++over;
    cost += length * (1 + kOverMainland * over / steps + (stretch.gear == Gear::reverse ? kInReverse : 0));
    if (stretch.gear != last) cost += kGearChange_m;
    last = stretch.gear;
  }
  return cost;
}

std::optional<Path> direct_turn(const Terrain& terrain, const Swings& swings, const Pose& from,
                                const Pose& to, double most_m) {
  if (auto straight = straight_on(from, to))
    return stays_inside(terrain.space, terrain.footprint, *straight) ? std::move(straight) : std::nullopt;
  const double longest = std::min(most_m, longest_turn_m(terrain, from, to));
  Connections turns{from, to, swings};
  while (auto turn = turns.next()) {
    if (length_m(*turn) > longest) break;
    if (stays_inside(terrain.space, terrain.footprint, *turn)) return turn;
  }
  return std::nullopt;
}

}  // namespace selion
