// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "owner_file.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

constexpr double kBorder_m = 0.02;  // a centimetre of repairs, and the file's decimals
constexpr double kCrumb_m2 = 0.05;

/// Of fields that are taken; even-odd where rings cross.
Shape shape_of(const Plane& plane, const OwnerFeature& feature) {
  std::vector<Shape> parts;
  for (const LonLatArea& part : feature.parts) {
    Outline outline{plane.to_local(part.shell), {}};
    for (const LonLatLine& hole : part.holes) outline.holes.push_back(plane.to_local(hole));
    const auto finite = [](const std::vector<Point>& ring) {
      return std::ranges::all_of(ring, [](Point p) { return std::isfinite(p.x_m) && std::isfinite(p.y_m); });
    };
    if (finite(outline.shell) && std::ranges::all_of(outline.holes, finite))
      parts.push_back(made_valid(polygon_of(outline)));
  }
  return united(parts);
}

Shape planned_ground(const Case& plan) {
  std::vector<Shape> all;
  for (const Ground& ground : plan.grounds) all.push_back(ground.area);
  return united(all);
}

bool is_named(const OwnerFeature& feature, const GivenField& given) {
  return !given.name || feature.name == *given.name || std::to_string(feature.number) == *given.name;
}

/// The field that the plan lies on.
const OwnerFeature* field_of(const std::vector<OwnerFeature>& features, const Case& plan,
                             const Shape& planned, const GivenField& given) {
  const OwnerFeature* best = nullptr;
  double most = 0;
  for (const OwnerFeature& feature : features) {
    if (!feature.what.empty() || !is_named(feature, given)) continue;
    const double both = area_m2(common(shape_of(plan.plane, feature), planned));
    if (both > most || (best == nullptr && given.name)) best = &feature, most = both;
  }
  return best;
}

void tell(Case& plan, const char* code, const Shape& where, const std::string& what) {
  const double area = area_m2(where);
  if (area <= kCrumb_m2) return;
  plan.findings.add(code, 0, place_in(parts_of(where).front()), {area, 0}, shown(area, 2) + " m2 " + what);
}

}  // namespace

void check_given(Case& plan, const GivenField& given) {
  const std::vector<OwnerFeature> features = read_owner_file(given);
  const Shape planned = planned_ground(plan);
  const OwnerFeature* field = field_of(features, plan, planned, given);
  if (field == nullptr) {
    plan.findings.add("given_field", 0, place_in(planned), {0, area_m2(planned)},
                      "no field of " + given.file.string() + (given.name ? " named " + *given.name : "") +
                          " lies where the plan does");
    return;
  }
  const Shape owned = shape_of(plan.plane, *field);
  tell(plan, "given_outside", without(planned, grown(owned, kBorder_m)),
       "of the plan's ground lie outside the field given");
  std::vector<Shape> kept_off;
  for (const OwnerFeature& feature : features) {
    if (feature.what.empty() || feature.what == "gate") continue;
    const Shape obstacle = shape_of(plan.plane, feature);
    tell(plan, "given_obstacle", common(planned, grown(obstacle, -kBorder_m)),
         "of the plan's ground lie in an obstacle of the field given");
    const bool water = feature.what == "water";
    kept_off.push_back(
        grown(obstacle, water ? plan.vehicle.water_margin_m : plan.vehicle.obstacle_clearance_m));
  }
  for (const Ground& ground : plan.grounds)
    if (ground.obstacles)
      kept_off.push_back(
          grown(ground.obstacles, std::max(plan.vehicle.water_margin_m, plan.vehicle.obstacle_clearance_m)));
  Shape left = without(owned, grown(planned, kBorder_m));
  if (!kept_off.empty()) left = without(left, united(kept_off));
  const double half = std::max(plan.vehicle.machine.working_width_m, plan.vehicle.machine.body_width_m) / 2;
  tell(plan, "given_left_out", grown(left, -half),
       "of the field given, wide enough for the machine, are in no block");
}

}  // namespace selion::verifying
