// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/layout/zones.hpp"

#include <algorithm>
#include <cstddef>

#include "selion/geometry/boolean.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

constexpr double kRoom_m =
    0.1;  // on either side: nobody steers a machine through a neck of just its own width
constexpr double kTouch_m = 0.01;

bool touches(const Polygon& a, const Polygon& b) {
  return !intersect(outset_round({a}, kTouch_m), {b}).empty();
}

/// What the machine can reach inside each core: the core grown back, within the block.
Polygons reached(const Block& block, const Polygons& cores, double half_m) {
  Polygons areas;
  for (const Polygon& core : cores)
    areas.push_back(intersect(outset_round({core}, half_m), {block.area}).front());
  return areas;
}

/// Necks and slivers go to the zone that they touch first, so that nothing of the block is forgotten.
void share_out(const Block& block, Polygons& zones) {
  for (const Polygon& rest : subtract(Polygons{block.area}, zones))
    for (Polygon& zone : zones) {
      if (!touches(rest, zone)) continue;
      Polygons joined = outset({rest}, kTouch_m / 2, 2);
      joined.push_back(zone);
      joined = intersect(unite(joined), {block.area});
      if (!joined.empty()) zone = joined.front();
      break;
    }
}

/// Both sides of a neck shorter than the machine reach into it: the ground belongs to the first.
void make_disjoint(Polygons& zones) {
  for (std::size_t i = 1; i < zones.size(); ++i) {
    const Polygons before{zones.begin(), zones.begin() + static_cast<std::ptrdiff_t>(i)};
    const Polygons own = subtract(Polygons{zones[i]}, before);
    if (!own.empty()) zones[i] = own.front();
  }
}

bool leads_into(const BlockGate& gate, const Polygon& zone) {
  constexpr double kInside_m = 0.1;
  return contains(zone, gate.at + kInside_m * unit(gate.inward_rad));
}

/// Obstacles beside the block that no zone touches, each to the zone next to it: that keeps off it.
void add_obstacles_beside(const Block& block, std::vector<Block>& zones) {
  for (const BlockObstacle& obstacle : block.obstacles) {
    const auto within = [&obstacle](double far_m) {
      const Polygons around = outset_round({obstacle.area}, far_m);
      return [around](const Block& zone) { return !intersect(around, {zone.area}).empty(); };
    };
    if (std::ranges::any_of(zones, [&](const Block& zone) { return touches(obstacle.area, zone.area); }))
      continue;
    for (const double far_m : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
      const auto next = std::ranges::find_if(zones, within(far_m));
      if (next == zones.end()) continue;
      next->obstacles.push_back(obstacle);
      break;
    }
  }
}

}  // namespace

std::vector<Block> zones_of(const Block& block, const Machine& machine) {
  const double half_m = std::max(machine.working_width_m, machine.body_width_m) / 2 + kRoom_m;
  Polygons cores = inset_round({evened(block.free).area}, half_m);
  std::erase_if(cores, [&](const Polygon& core) {
    return area_m2(core) < machine.working_width_m * machine.working_width_m;
  });
  if (cores.size() < 2) return {block};
  Polygons areas = reached(block, cores, half_m);
  make_disjoint(areas);
  share_out(block, areas);
  make_disjoint(areas);
  std::vector<Block> zones;
  for (const Polygon& area : areas) {
    Block zone = block;
    zone.area = area;
    const Polygons free = intersect({block.free}, {area});
    if (free.empty()) continue;
    zone.free = free.front();
    std::erase_if(zone.gates, [&](const BlockGate& gate) { return !leads_into(gate, area); });
    std::erase_if(zone.obstacles,
                  [&](const BlockObstacle& obstacle) { return !touches(obstacle.area, area); });
    zones.push_back(std::move(zone));
  }
  add_obstacles_beside(block, zones);
  return zones;
}

}  // namespace selion
