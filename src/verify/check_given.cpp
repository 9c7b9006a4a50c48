// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_given.hpp"

#include <algorithm>
#include <cmath>

#include "owner_ground.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

constexpr double kBorder_m = 0.02;
constexpr double kReach_m = 50;  // farther obstacles are of other fields
// A repair moves a border by a centimetre at most; the planner's grid and the file's decimals add to it.
constexpr double kRepaired_m = 0.012;

Shape planned_ground(const Case& plan) {
  std::vector<Shape> all;
  for (const Ground& ground : plan.grounds) all.push_back(ground.area);
  return united(all);
}

/// By its number, or as `selion plan` calls it: those without a name by their file, namesakes "home (2)".
bool is_named(const OwnerFeature& feature, const GivenField& given) {
  if (!given.name || *given.name == std::to_string(feature.number)) return true;
  const std::string stem = given.file.stem().string();
  const std::string own = feature.name.empty() ? stem : feature.name;
  if (*given.name == own) return true;
  if (feature.name.empty() && *given.name == stem + " " + std::to_string(feature.number)) return true;
  const bool longer = given.name->starts_with(own + " (") && given.name->ends_with(")");
  return longer && given.name->find_first_not_of("0123456789", own.size() + 2) == given.name->size() - 1;
}

/// The field whose ground is most nearly the plan's: extents and fields that overlap lie there too.
const OwnerFeature* field_of(const std::vector<OwnerFeature>& features, const Case& plan,
                             const Shape& planned, const GivenField& given) {
  const OwnerFeature* best = nullptr;
  double most = 0;
  for (const OwnerFeature& feature : features) {
    if (feature.role != OwnerRole::field || !is_named(feature, given)) continue;
    const Shape ground = ground_of(plan.plane, feature).area;
    const double both = area_m2(common(ground, planned));
    const double share = both / (area_m2(ground) + area_m2(planned) - both);
    if (share > most || (best == nullptr && given.name)) best = &feature, most = share;
  }
  return best;
}

/// Each place of `where` that no repair explains. @returns whether there is one.
bool tell(Case& plan, const char* code, const Shape& where, const std::string& what) {
  bool found = false;
  for (const Shape& part : parts_of(where)) {
    if (!(area_m2(grown(part, -kRepaired_m / 2)) > 0)) continue;
    found = true;
    const double area = area_m2(part);
    plan.findings.add(code, 0, place_in(part), {area, 0}, shown(area, area < 0.1 ? 4 : 2) + " m2 " + what);
  }
  return found;
}

double kept_m(const Vehicle& vehicle, const OwnerFeature& obstacle) {
  return obstacle.role == OwnerRole::water ? vehicle.water_margin_m : vehicle.obstacle_clearance_m;
}

/// No block may lie in it, nor nearer than is kept where no obstacle of the plan keeps the machine off.
void check_obstacle(Case& plan, const Shape& planned, const OwnerFeature& feature, const Shape& obstacle) {
  constexpr double kRounded = 0.01;  // arcs are drawn as chords
  const std::string name = (feature.name.empty() ? "" : "'" + feature.name + "' of ") + feature.where;
  if (tell(plan, "given_obstacle", common(planned, obstacle),
           "of the plan's ground lie in the obstacle " + name))
    return;
  const double kept = kept_m(plan.vehicle, feature);
  const Shape near = grown(obstacle, std::max(0.0, (1 - kRounded) * kept - kInside_m));
  for (const Ground& ground : plan.grounds) {
    const auto drives_there = [&](const Driven& d) { return d.record->block == ground.block; };
    if (std::ranges::none_of(plan.drives, drives_there)) continue;
    const Shape at_risk = without(common(ground.area, near), obstacle);
    tell(plan, "given_obstacle", ground.obstacles ? without(at_risk, ground.obstacles) : at_risk,
         "of the plan's ground lie within " + shown(kept, 2) + " m of the obstacle " + name +
             ", and the plan does not keep off it");
  }
}

/// What the owner has, and no block: not what obstacles and holes with their clearance take, nor what is too
/// narrow for the machine or too small to be kept.
Shape left_out(const Case& plan, const OwnerGround& owned, const Shape& planned,
               std::vector<Shape> kept_off) {
  constexpr double kSmallest_m2 = 1;
  const Vehicle& vehicle = plan.vehicle;
  const double most_m = std::max(vehicle.water_margin_m, vehicle.obstacle_clearance_m);
  for (const Ground& ground : plan.grounds)
    if (ground.obstacles) kept_off.push_back(grown(ground.obstacles, most_m));
  kept_off.push_back(grown(owned.holes, vehicle.obstacle_clearance_m));
  std::vector<Shape> left;
  const double half = half_tool_m(vehicle);
  for (const Shape& part :
       parts_of(without(without(owned.area, grown(planned, kBorder_m)), united(kept_off))))
    if (area_m2(part) >= kSmallest_m2 && area_m2(grown(part, -half)) > 0) left.push_back(part);
  return united(left);
}

}  // namespace

bool is_name(const std::string& owned, const std::string& planned) {
  return owned == planned || std::ranges::any_of(owned, [](unsigned char c) { return c > 127; });
}

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
  const OwnerGround owned = ground_of(plan.plane, *field);
  tell(plan, "given_outside", without(planned, owned.area),
       "of the plan's ground lie outside the field given, or in a hole of it");
  std::vector<Shape> kept_off;
  for (const OwnerFeature& feature : features) {
    if (feature.role == OwnerRole::field) continue;
    const Shape obstacle = obstacle_of(plan.plane, feature);
    if (!(distance_m(obstacle, planned) < kReach_m)) continue;
    check_obstacle(plan, planned, feature, obstacle);
    kept_off.push_back(grown(obstacle, kept_m(plan.vehicle, feature)));
  }
  tell(plan, "given_left_out", left_out(plan, owned, planned, std::move(kept_off)),
       "of the field given, wide enough for the machine, are in no block");
  check_given_kinds(plan, features);
  check_given_gates(plan, features, given);
}

}  // namespace selion::verifying
