// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <functional>
#include <numbers>

#include "plan/records.hpp"
#include "plan_check.hpp"
#include "selion/planfile/planfile.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;

Machine husky() {
  for (const MachinePreset& preset : machine_presets())
    if (preset.name == "husky") return preset.machine;
  return {};
}

/// Two swaths 0.75 m apart in a field that reaches `beyond_m` further than their ends, the second one reached
/// by two quarter turns on the spot; the tool takes a second to rise and to come down.
Plan two_swaths(const Machine& m, double beyond_m) {
  const double end = 20;
  const auto pivot = [](Point at, double heading) {
    return Stretch{{at, heading, 0, 0, 0}, Gear::forward, kPi / 2};
  };
  const Path way{pivot({end, 0}, 0), {line({end, 0}, {end, 0.75})}, pivot({end, 0.75}, kPi / 2)};
  PlannedBlock planned;
  planned.block.area = {{{-2, -2}, {end + beyond_m, -2}, {end + beyond_m, 3}, {-2, 3}}, {}};
  planned.block.free = planned.block.area;
  planned.layout.mainland = {planned.block.area};
  planned.layout.ab = {{0, 0}, {end, 0}};
  planned.layout.swaths = {{"1", 1, {0, 0}, {end, 0}}, {"2", 2, {0, 0.75}, {end, 0.75}}};
  planned.route.pieces = {{PieceKind::swath, "1", {{line({0, 0}, {end, 0})}}},
                          {PieceKind::turn, "", way},
                          {PieceKind::swath, "2", {{line({end, 0.75}, {0, 0.75})}}}};
  const LocalFrame frame = LocalFrame::centred({3.4, 46.3});
  Plan plan;
  plan.file.proj = frame.proj();
  plan.file.origin = frame.origin();
  plan.file.job_json = "{}";
  plan.file.id = "0123456789abcdef";
  plan.file.fields.push_back({{to_lonlat(frame, planned.block.area)}, "two swaths", 115, {}});
  add_records(plan.file, planned, drive_of(planned.route, m), frame, m);
  return plan;
}

std::vector<PieceRecord*> pivots_of(Plan& plan) {
  std::vector<PieceRecord*> pivots;
  for (PieceRecord& piece : plan.file.trajectories.at(0).pieces)
    if (piece.kind == "pivot") pivots.push_back(&piece);
  return pivots;
}

}  // namespace

TEST_CASE("a plan with pivots is right and its file is read back", "[plan][pivot]") {
  const Machine m = husky();
  Plan plan = two_swaths(m, 0.7);
  CHECK(faults_of(plan, m) == std::vector<std::string>{});
  REQUIRE(pivots_of(plan).size() == 2);
  CHECK(*pivots_of(plan)[0]->angle_rad == Approx(kPi / 2));
  CHECK(*pivots_of(plan)[0]->duration_s > 1);
  const std::string text = to_geojson(plan.file);
  const PlanFile read = plan_from_geojson(text, "test");
  CHECK(to_geojson(read) == text);
  Plan again = plan;
  again.file = read;
  CHECK(*pivots_of(again)[1]->angle_rad == Approx(kPi / 2).margin(1e-8));
}

TEST_CASE("the tool is up before a pivot", "[plan][pivot]") {
  Machine m = husky();
  m.tool_raise_s = 1;
  Plan plan = two_swaths(m, 0.7);
  CHECK(faults_of(plan, m) == std::vector<std::string>{});
  const auto& pieces = plan.file.trajectories.at(0).pieces;
  const auto first =
      std::find_if(pieces.begin(), pieces.end(), [](const PieceRecord& p) { return p.kind == "pivot"; });
  REQUIRE(first != pieces.begin());
  CHECK((first - 1)->kind == "wait");
  CHECK(*(first - 1)->duration_s == Approx(1));
}

TEST_CASE("the check of plans rejects wrong pivots", "[plan][pivot]") {
  const Machine m = husky();
  const auto faults_after = [&](const std::function<void(Plan&)>& spoil) {
    Plan plan = two_swaths(m, 0.7);
    spoil(plan);
    return faults_of(plan, m).size();
  };
  CHECK(faults_of(two_swaths(m, 0.55), m).size() > 0);  // the circle of 0.6 m leaves the field
  CHECK(faults_after([](Plan& p) { *pivots_of(p)[0]->angle_rad = -kPi / 2; }) > 0);
  CHECK(faults_after([](Plan& p) { *pivots_of(p)[0]->angle_rad += 1e-5; }) > 0);
  CHECK(faults_after([](Plan& p) { pivots_of(p)[1]->angle_rad.reset(); }) > 0);
  CHECK(faults_after([](Plan& p) { *pivots_of(p)[0]->duration_s -= 0.01; }) > 0);
  CHECK(faults_after([](Plan& p) { pivots_of(p)[0]->tool = 1; }) > 0);
  Machine may_not = m;
  may_not.may_pivot = false;
  CHECK(faults_of(two_swaths(m, 0.7), may_not).size() > 0);
  may_not.may_pivot = true;
  may_not.kind = MachineKind::car;
  CHECK(faults_of(two_swaths(m, 0.7), may_not).size() > 0);
}
