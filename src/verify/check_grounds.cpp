// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "check.hpp"

namespace selion::verifying {
namespace {

Outline local_outline(const Plane& plane, const LonLatArea& area) {
  Outline outline{plane.to_local(area.shell), {}};
  for (const LonLatLine& hole : area.holes) outline.holes.push_back(plane.to_local(hole));
  return outline;
}

Shape obstacles_of(const Case& plan, int block) {
  std::vector<Shape> shapes;
  for (const ObstacleRecord& obstacle : plan.plan.obstacles)
    if (obstacle.block == block)
      shapes.push_back(made_valid(polygon_of(local_outline(plan.plane, obstacle.area))));
  return shapes.empty() ? Shape{} : united(shapes);
}

/// Of the shell only: what a raised tool may pass over.
Shape without_holes(const Shape& area) {
  std::vector<Shape> shells;
  for (const Outline& outline : outlines_of(area)) shells.push_back(polygon_of(outline.shell));
  return united(shells);
}

Shape holes_of(const Shape& area) { return without(without_holes(area), area); }

void check_obstacle(Case& plan, const Ground& ground, const ObstacleRecord& obstacle) {
  constexpr double kRounded_m = 0.011;  // a centimetre of repairs, and the file's decimals
  const bool water = obstacle.what == "water";
  const double wanted = water ? plan.vehicle.water_margin_m : plan.vehicle.obstacle_clearance_m;
  const Shape shape = made_valid(polygon_of(local_outline(plan.plane, obstacle.area)));
  const double there_is = distance_m(shape, ground.area);
  if (there_is >= wanted - kRounded_m) return;
  plan.findings.add("obstacle_clearance", ground.block, place_in(shape), {there_is, wanted},
                    (obstacle.name.empty() ? "an obstacle" : obstacle.name) + " lies " + shown(there_is, 3) +
                        " m from the ground that is worked; " + shown(wanted, 3) + " m are asked for");
}

void add_ground(Case& plan, int block, const LonLatArea& part) {
  const Shape given = polygon_of(local_outline(plan.plane, part));
  const Shape area = made_valid(given);
  if (area != given || !(area_m2(area) > 0))
    plan.findings.add("field_shape", block, place_in(area), {area_m2(area), 0},
                      "the block's border crosses itself, or encloses nothing");
  const Shape obstacles = obstacles_of(plan, block);
  const Shape grown_area = grown(area, kInside_m);
  const Shape room = obstacles ? without(grown_area, grown(obstacles, -kInside_m)) : grown_area;
  Shape high = room;
  if (plan.vehicle.overhang_m > 0) {
    high = without(grown(without_holes(area), plan.vehicle.overhang_m + kInside_m),
                   grown(holes_of(area), -kInside_m));
    if (obstacles) high = without(high, grown(obstacles, -kInside_m));
  }
  plan.grounds.push_back(
      {block, area, obstacles, Prepared{room}, Prepared{border_of(room)}, Prepared{border_of(high)}});
}

}  // namespace

const Ground* Case::ground(int block) const {
  for (const Ground& g : grounds)
    if (g.block == block) return &g;
  return nullptr;
}

void check_grounds(Case& plan) {
  if (plan.plan.fields.size() != 1) {
    plan.findings.add("field", 0, std::nullopt, {1.0 * static_cast<double>(plan.plan.fields.size()), 1},
                      "the file has no field, or several");
    return;
  }
  const FieldRecord& field = plan.plan.fields.front();
  double sum = 0;
  for (std::size_t i = 0; i < field.parts.size(); ++i) {
    add_ground(plan, static_cast<int>(i) + 1, field.parts[i]);
    sum += area_m2(plan.grounds.back().area);
  }
  const double slack = 0.01 + 1e-5 * sum;
  if (!(std::abs(sum - field.area_m2) <= slack))
    plan.findings.add("field_area", 0, std::nullopt, {field.area_m2, sum},
                      "the field is said to have " + shown(field.area_m2, 1) + " m2, its border encloses " +
                          shown(sum, 1) + " m2");
  for (std::size_t i = 0; i < plan.grounds.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const double both = area_m2(common(plan.grounds[i].area, plan.grounds[k].area)); both > slack)
        plan.findings.add("field_shape", plan.grounds[i].block, std::nullopt, {both, 0},
                          "blocks overlap by " + shown(both, 2) + " m2");
  for (const ObstacleRecord& obstacle : plan.plan.obstacles)
    if (const Ground* ground = plan.ground(obstacle.block)) check_obstacle(plan, *ground, obstacle);
}

}  // namespace selion::verifying
