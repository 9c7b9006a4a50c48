// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "check_given.hpp"
#include "owner_ground.hpp"

namespace selion::verifying {
namespace {

constexpr double kMost = 0.5;  // of an obstacle's ground: circles and bands are drawn with corners

std::string kind_of(OwnerRole role) {
  if (role == OwnerRole::water) return "water";
  return role == OwnerRole::no_go ? "no_go" : "obstacle";
}

Shape shape_of(const Plane& plane, const LonLatArea& area) {
  Outline outline{plane.to_local(area.shell), {}};
  for (const LonLatLine& hole : area.holes) outline.holes.push_back(plane.to_local(hole));
  return made_valid(polygon_of(outline));
}

struct OwnerObstacle {
  Shape shape;
  std::string kind;
};

}  // namespace

void check_given_kinds(Case& plan, const std::vector<OwnerFeature>& features) {
  if (plan.plan.obstacles.empty()) return;
  std::vector<OwnerObstacle> owned;
  for (const OwnerFeature& feature : features)
    if (is_obstacle(feature.role)) owned.push_back({obstacle_of(plan.plane, feature), kind_of(feature.role)});
  for (const ObstacleRecord& obstacle : plan.plan.obstacles) {
    const Shape shape = shape_of(plan.plane, obstacle.area);
    const auto is_it = [&](const OwnerObstacle& own) {
      return area_m2(common(own.shape, shape)) > kMost * area_m2(shape);
    };
    const auto same = [&](const OwnerObstacle& own) { return own.kind == obstacle.what && is_it(own); };
    if (std::ranges::any_of(owned, same)) continue;
    const auto other = std::ranges::find_if(owned, is_it);
    plan.findings.add("given_obstacle", obstacle.block, place_in(shape), {area_m2(shape), 0},
                      "the plan's obstacle '" + obstacle.name + "' is said to be " + obstacle.what +
                          (other == owned.end() ? "; the owner has none there (more are given by --obstacles)"
                                                : "; the owner's is " + other->kind));
  }
}

}  // namespace selion::verifying
