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

/// With what is kept from them, but for `less_m`. Those that the file calls another block's stand where they
/// stand: their ground alone.
Shape obstacles_of(const Case& plan, int block, double less_m) {
  std::vector<Shape> shapes;
  for (const ObstacleRecord& obstacle : plan.plan.obstacles) {
    const double margin =
        obstacle.what == "water" ? plan.vehicle.water_margin_m : plan.vehicle.obstacle_clearance_m;
    const double kept = obstacle.block == block ? margin : 0;
    shapes.push_back(grown(made_valid(polygon_of(local_outline(plan.plane, obstacle.area))), kept - less_m));
  }
  return shapes.empty() ? Shape{} : united(shapes);
}

/// Of the shell only: what a raised tool may pass over.
Shape without_holes(const Shape& area) {
  std::vector<Shape> shells;
  for (const Outline& outline : outlines_of(area)) shells.push_back(polygon_of(outline.shell));
  return united(shells);
}

Shape holes_of(const Shape& area) { return without(without_holes(area), area); }

void add_ground(Case& plan, int block, const LonLatArea& part) {
  const Shape given = polygon_of(local_outline(plan.plane, part));
  const Shape area = made_valid(given);
  // Rounded to the file's decimals, a border that all but touches itself may touch.
  constexpr double kRounded_m2 = 0.01;
  if (!(area_m2(area) > 0) || std::abs(area_m2(area) - area_m2(given)) > kRounded_m2)
    plan.findings.add("field_shape", block, place_in(area), {area_m2(area), 0},
                      "the block's border crosses itself, or encloses nothing");
  const Shape obstacles = obstacles_of(plan, block, 0);
  const Shape hard = obstacles_of(plan, block, kInside_m);
  const Shape grown_area = grown(area, kInside_m);
  const Shape room = hard ? without(grown_area, hard) : grown_area;
  Shape high = room;
  if (plan.vehicle.overhang_m > 0) {
    high = without(grown(without_holes(area), plan.vehicle.overhang_m + kInside_m),
                   grown(holes_of(area), -kInside_m));
    if (hard) high = without(high, hard);
  }
  plan.grounds.push_back({block, area, obstacles, obstacles ? without(area, obstacles) : area, Prepared{room},
                          Border{border_of(room)}, Border{border_of(high)}});
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
}

}  // namespace selion::verifying
