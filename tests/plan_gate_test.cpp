// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>

#include "field_samples.hpp"
#include "plan_check.hpp"
#include "selion/field/frame.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"
#include "verify_samples.hpp"

using namespace selion;

namespace {

constexpr double kLong_m = 220;
constexpr double kWide_m = 140;

/// A rectangle with a gate at `share` of its longer side, 0 and 1 being corners.
Field field_with_gate(double share) {
  Field field = field_of_metres({{{{0, 0}, {kLong_m, 0}, {kLong_m, kWide_m}, {0, kWide_m}}, {}}});
  const LonLat a = field.parts.at(0).shell.at(0);
  const LonLat b = field.parts.at(0).shell.at(1);
  const LonLat at{a.lon_deg + share * (b.lon_deg - a.lon_deg), a.lat_deg + share * (b.lat_deg - a.lat_deg)};
  field.gates.push_back(Gate{.name = "lane", .at = at, .width_m = {}});
  return field;
}

double from_gate_m(const Plan& plan, LonLat at) {
  const LocalFrame frame = LocalFrame::centred(plan.file.gates.at(0).at);
  return length_m(frame.to_local(at));
}

}  // namespace

TEST_CASE("the drive starts and ends at its gate, in a corner too", "[plan][gate]") {
  const double share = GENERATE(0.0, 0.002, 0.5, 0.996, 1.0);
  const auto machine = GENERATE("robot-3m", "tractor-6m");
  CAPTURE(share, machine);
  const Job job = job_of(settings_of_toml("[machine]\npreset = \"" + std::string{machine} + "\"\n", "test"));

  const auto planned = plan(field_with_gate(share), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  CHECK(faults_of(*planned, job.machine) == std::vector<std::string>{});
  const TrajectoryRecord& drive = planned->file.trajectories.at(0);
  const double near_m = 2 * job.machine.body_width_m + job.machine.front_m + job.machine.rear_m;
  CHECK(from_gate_m(*planned, drive.line.front()) < near_m);
  CHECK(from_gate_m(*planned, drive.line.back()) < near_m);
  CHECK(planned->file.warnings.empty());
  const bool askew = std::any_of(planned->notes.begin(), planned->notes.end(), [](const std::string& note) {
    return note.find("inside gate lane square to the border") != std::string::npos;
  });
  CHECK(askew == (share != 0.5));
}

TEST_CASE("the last headland pass ends near the gate, wherever that is", "[plan][gate]") {
  const double share = GENERATE(0.1, 0.5, 0.9);
  const auto* const settings = GENERATE("preset = \"robot-3m\"\n", "preset = \"tractor-6m\"\n",
                                        "preset = \"tractor-6m\"\n[headland]\ncorners = \"fill\"\n");
  CAPTURE(share, settings);
  const Job job = job_of(settings_of_toml("[machine]\n" + std::string{settings}, "test"));

  const auto planned = plan(field_with_gate(share), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const std::vector<PieceRecord>& pieces = planned->file.trajectories.at(0).pieces;
  const auto last =
      std::find_if(pieces.rbegin(), pieces.rend(), [](const PieceRecord& piece) { return piece.tool == 1; });
  REQUIRE(last != pieces.rend());
  CHECK(last->kind == "headland_pass");
  double way_m = 0;
  for (auto piece = pieces.rbegin(); piece != last; ++piece) way_m += piece->length_m;
  CHECK(way_m < 12 / max_curvature_per_m(job.machine) + 2 * job.machine.working_width_m);
}

TEST_CASE("a post by the gate has the drive start elsewhere, in the order that is asked for",
          "[plan][gate]") {
  struct Post {
    double aside_m;
    double in_m;
    const char* machine;
  };
  const auto post = GENERATE(values<Post>(
      {{1, 2.2, "robot-3m"}, {1.2, 2, "robot-3m"}, {0, 9, "tractor-6m"}, {1.2, 4, "tractor-6m"}}));
  CAPTURE(post.aside_m, post.in_m, post.machine);
  const Job job =
      job_of(settings_of_toml("[machine]\npreset = \"" + std::string{post.machine} + "\"\n", "test"));
  const Point at{50 + post.aside_m, post.in_m};
  constexpr double kHalf_m = 0.07;
  Field field = field_of_metres({{{{0, 0}, {100, 0}, {100, 80}, {0, 80}}, {}}});
  const Field standing = field_of_metres({{{at + Point{-kHalf_m, -kHalf_m}, at + Point{kHalf_m, -kHalf_m},
                                            at + Point{kHalf_m, kHalf_m}, at + Point{-kHalf_m, kHalf_m}},
                                           {}}});
  field.obstacles.push_back(Obstacle{"post", ObstacleKind::obstacle, standing.parts.at(0)});
  const LonLat a = field.parts.at(0).shell.at(0);
  const LonLat b = field.parts.at(0).shell.at(1);
  field.gates.push_back(
      Gate{.name = "lane", .at = {(a.lon_deg + b.lon_deg) / 2, (a.lat_deg + b.lat_deg) / 2}, .width_m = {}});

  const auto planned = plan(field, job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  CHECK(faults_of(*planned, job.machine) == std::vector<std::string>{});
  CHECK(planned->blocks.at(0).covered_m2 >= 0.96 * planned->blocks.at(0).area_m2);
  const std::string first = [&] {
    for (const PieceRecord& piece : planned->file.trajectories.at(0).pieces)
      if (piece.tool == 1) return piece.kind;
    return std::string{};
  }();
  CHECK(first == "swath");
}

TEST_CASE("gates are counted over all blocks, planned or not", "[plan][gate]") {
  Field field = field_of_metres({{{{0, 0}, {60, 0}, {60, 50}, {0, 50}}, {}},
                                 {{{70, 0}, {72, 0}, {72, 1600}, {70, 1600}}, {}},
                                 {{{80, 0}, {142, 0}, {142, 50}, {80, 50}}, {}}});
  const auto at = [&](std::size_t part, std::size_t corner) { return field.parts.at(part).shell.at(corner); };
  for (const LonLat corner : {at(2, 0), at(1, 0), at(0, 0), at(2, 2)})
    field.gates.push_back({"", corner, {}});
  const int start = GENERATE(1, 2, 3);
  CAPTURE(start);

  const PlanFile file = written(
      field, "[machine]\npreset = \"robot-3m\"\n[route]\nstart = \"gate:" + std::to_string(start) + "\"\n");

  REQUIRE(file.gates.size() == 4);
  CHECK(file.gates.at(0).block == 1);  // the strip, too narrow for the machine
  REQUIRE(file.trajectories.size() == 2);
  const auto begins_near = [](const TrajectoryRecord& t, LonLat gate) {
    return std::hypot(t.line.front().lon_deg - gate.lon_deg, t.line.front().lat_deg - gate.lat_deg) < 1e-4;
  };
  CHECK(file.trajectories.at(0).block == 2);
  CHECK(begins_near(file.trajectories.at(0), at(2, start == 3 ? 2 : 0)));
  CHECK(begins_near(file.trajectories.at(1), at(0, 0)));
  CHECK(text_of(verify(file, std::nullopt)) == "");
}
