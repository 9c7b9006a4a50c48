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
  std::string name;
};

std::string text_of(const std::string& kind, const std::string& name) {
  return kind + (name.empty() ? "" : ", '" + name + "'");
}

/// The plan's obstacles against those of the owner.
class GivenObstacles {
 public:
  GivenObstacles(Case& plan, const std::vector<OwnerFeature>& features) : plan_{plan} {
    for (const OwnerFeature& feature : features)
      if (is_obstacle(feature.role))
        owned_.push_back({obstacle_of(plan.plane, feature), kind_of(feature.role), feature.name});
  }

  void check(const ObstacleRecord& obstacle) {
    const Shape shape = shape_of(plan_.plane, obstacle.area);
    const auto is_it = [&](const OwnerObstacle& own) {
      return area_m2(common(own.shape, shape)) > kMost * area_m2(shape);
    };
    const auto same = std::ranges::count_if(owned_, [&](const OwnerObstacle& own) {
      return own.kind == obstacle.what && is_name(own.name, obstacle.name) && is_it(own);
    });
    if (same == 0) {
      const auto other = std::ranges::find_if(owned_, is_it);
      say(obstacle, shape,
          other == owned_.end() ? "the owner has none there (more are given by --obstacles)"
                                : "the owner's is " + text_of(other->kind, other->name));
    } else if (std::ranges::count(plan_.plan.obstacles, obstacle) > same) {
      say(obstacle, shape, "it is there more than once");
    }
  }

 private:
  void say(const ObstacleRecord& obstacle, const Shape& shape, const std::string& what) {
    plan_.findings.add(
        "given_obstacle", obstacle.block, place_in(shape), {area_m2(shape), 0},
        "the plan's obstacle is said to be " + text_of(obstacle.what, obstacle.name) + "; " + what);
  }

  Case& plan_;
  std::vector<OwnerObstacle> owned_;
};

}  // namespace

void check_given_kinds(Case& plan, const std::vector<OwnerFeature>& features) {
  if (plan.plan.obstacles.empty()) return;
  GivenObstacles given{plan, features};
  for (const ObstacleRecord& obstacle : plan.plan.obstacles) given.check(obstacle);
}

}  // namespace selion::verifying
