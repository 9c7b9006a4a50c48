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

/// What stands in the field, whatever block the file calls it of.
struct Standing {
  Shape obstacles;  ///< with what is kept from them
  Shape kept;       ///< these, and holes with what is kept from those
  Shape hard;       ///< the same less kInside_m
};

double kept_m(const Case& plan, const ObstacleRecord& obstacle) {
  return obstacle.what == "water" ? plan.vehicle.water_margin_m : plan.vehicle.obstacle_clearance_m;
}

Shape grown_by(const Case& plan, const ObstacleRecord& obstacle, double by_m) {
  return grown(made_valid(polygon_of(local_outline(plan.plane, obstacle.area))), by_m);
}

Shape obstacles_of(const Case& plan, double share, double less_m) {
  std::vector<Shape> shapes;
  for (const ObstacleRecord& obstacle : plan.plan.obstacles)
    shapes.push_back(grown_by(plan, obstacle, share * kept_m(plan, obstacle) - less_m));
  return shapes.empty() ? Shape{} : united(shapes);
}

/// Obstacles, and fences on them, of which nothing is left less kInside_m.
Shape thin_obstacles(const Case& plan) {
  constexpr double kCorner = 3;  // a right angle's tip lies 1.4 times as far off: it is not thin
  std::vector<Shape> shapes;
  for (const ObstacleRecord& obstacle : plan.plan.obstacles) {
    const double kept = kept_m(plan, obstacle);
    if (kept > kInside_m) continue;
    const Shape rest = grown_by(plan, obstacle, kept - kInside_m);
    shapes.push_back(without(grown_by(plan, obstacle, kept), grown(rest, kCorner * kInside_m)));
  }
  return shapes.empty() ? Shape{} : united(shapes);
}

/// Holes of all blocks together in which neither a block lies nor an obstacle: those keep their own distance.
Shape holes_of(const Case& plan, const std::vector<Shape>& areas) {
  constexpr double kCrack_m = 0.004;  // between blocks, or left by the file's decimals
  const Shape closed = grown(united(areas), kCrack_m);
  std::vector<Shape> enclosed;
  for (const Outline& outline : outlines_of(closed))
    for (const std::vector<Point>& hole : outline.holes) enclosed.push_back(polygon_of(hole));
  if (enclosed.empty()) return united({});
  Shape holes = without(united(enclosed), closed);
  if (const Shape obstacles = obstacles_of(plan, 0, 0)) holes = without(holes, obstacles);
  return grown(grown(holes, -kCrack_m), 2 * kCrack_m);
}

Standing standing_in(const Case& plan, const std::vector<Shape>& areas) {
  const Shape holes = holes_of(plan, areas);
  const double clearance = plan.vehicle.obstacle_clearance_m;
  const auto with_holes = [&](const Shape& obstacles, double less_m) {
    std::vector<Shape> all{grown(holes, clearance - less_m)};
    if (obstacles) all.push_back(obstacles);
    return united(all);
  };
  const Shape obstacles = obstacles_of(plan, 1, 0);
  return {obstacles, with_holes(obstacles, 0), with_holes(obstacles_of(plan, 1, kInside_m), kInside_m)};
}

Shape area_of(Case& plan, int block, const LonLatArea& part) {
  const Shape given = polygon_of(local_outline(plan.plane, part));
  Shape area = united(parts_of(made_valid(given)));  // without lines that touching borders leave
  // Rounded to the file's decimals, a border that all but touches itself may touch.
  constexpr double kRounded_m2 = 0.01;
  if (!(area_m2(area) > 0) || std::abs(area_m2(area) - area_m2(given)) > kRounded_m2)
    plan.findings.add("field_shape", block, place_in(area), {area_m2(area), 0},
                      "the block's border crosses itself, or encloses nothing");
  return area;
}

void add_grounds(Case& plan, const std::vector<LonLatArea>& parts) {
  std::vector<Shape> areas;
  areas.reserve(parts.size());
  for (const LonLatArea& part : parts)
    areas.push_back(area_of(plan, static_cast<int>(areas.size()) + 1, part));
  const Standing standing = standing_in(plan, areas);
  const Shape beside_obstacles = obstacles_of(plan, 0, -kInside_m);
  if (const Shape thin = thin_obstacles(plan); thin && area_m2(thin) > 0) plan.thin.emplace(border_of(thin));
  for (const Shape& area : areas) {
    const Shape room = without(grown(area, kInside_m), standing.hard);
    const Shape border = border_of(filled(area));
    plan.grounds.push_back({static_cast<int>(plan.grounds.size()) + 1, area,
                            beside_obstacles ? without(border, beside_obstacles) : border, standing.obstacles,
                            standing.kept, without(area, standing.kept), Prepared{room},
                            Border{border_of(room)}});
  }
}

void check_overlaps(Case& plan, double slack_m2) {
  std::vector<Box> boxes;
  for (const Ground& ground : plan.grounds) boxes.push_back(box_of(ground.area));
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (apart(boxes[i], boxes[k])) continue;
      if (const double both = area_m2(common(plan.grounds[i].area, plan.grounds[k].area)); both > slack_m2)
        plan.findings.add("field_shape", plan.grounds[i].block, std::nullopt, {both, 0},
                          "blocks overlap by " + shown(both, 2) + " m2");
    }
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
  add_grounds(plan, field.parts);
  for (const Ground& ground : plan.grounds) sum += area_m2(ground.area);
  const double slack = 0.01 + 1e-5 * sum;
  if (!(std::abs(sum - field.area_m2) <= slack))
    plan.findings.add("field_area", 0, std::nullopt, {field.area_m2, sum},
                      "the field is said to have " + shown(field.area_m2, 1) + " m2, its border encloses " +
                          shown(sum, 1) + " m2");
  check_overlaps(plan, slack);
}

}  // namespace selion::verifying
