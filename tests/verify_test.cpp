// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "field_samples.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"
#include "selion/verify/verify.hpp"
#include "verify/plane.hpp"
#include "verify_mutants.hpp"
#include "verify_samples.hpp"

using namespace selion;

namespace {

Field small_field() { return field_of_metres({{{{0, 0}, {62, 3}, {58, 44}, {30, 50}, {-4, 41}}, {}}}); }
Field holed_field() {
  return field_of_metres(
      {{{{0, 0}, {70, 0}, {70, 50}, {0, 50}}, {{{30, 20}, {30, 28}, {38, 28}, {38, 20}}}}});
}
Field gated_field() {
  Field field = holed_field();
  const LonLatLine& shell = field.parts.at(0).shell;
  field.gates.push_back({"south", shell.at(1), 4.0});
  field.gates.push_back({"north", shell.at(3), 5.0});
  return field;
}
Field two_blocks() {
  return field_of_metres(
      {{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}, {}}, {{{50, 0}, {90, 0}, {90, 35}, {50, 35}}, {}}});
}

/// Valid plans of several kinds, small so that a thousand mutants are soon checked.
std::vector<PlanFile> originals() {
  const std::string robot = "[machine]\npreset = \"robot-3m\"\n";
  return {written(small_field(), robot),
          written(gated_field(), robot + "run_in_m = 2\ntool_lower_s = 2\ntool_raise_s = 1\n"),
          written(two_blocks(), robot),
          written(small_field(), "[machine]\npreset = \"p3\"\nmay_reverse = false\n"),
          written(holed_field(), "[machine]\npreset = \"husky\"\nmay_pivot = true\n"),
          written(small_field(), robot + "[headland]\ncorners = \"fill\"\norder = \"first\"\n")};
}

struct Score {
  int mutants = 0;
  int rejected = 0;  ///< with a right code
};

void score(const PlanFile& original, const Mutation& mutation, std::uint64_t seed, Score& score) {
  PlanFile mutant = original;
  Dice dice{seed};
  if (!mutation.apply(mutant, dice) || mutant == original) return;
  ++score.mutants;
  const Verdict verdict = verify(mutant, std::nullopt);
  const bool right = std::ranges::any_of(verdict.findings, [&](const Finding& finding) {
    return std::ranges::find(mutation.codes, finding.code) != mutation.codes.end();
  });
  score.rejected += right ? 1 : 0;
  if (!right)
    std::printf("%s, seed %d: %s\n", mutation.name, static_cast<int>(seed),
                verdict.findings.empty() ? "not rejected" : text_of(verdict).c_str());
}

}  // namespace

TEST_CASE("where the first strip is left out, the others lie at whole strips from its AB line", "[verify]") {
  Field field = field_of_metres({{{{0, 0}, {200, 0}, {200, 100}, {0, 100}}, {}}});
  const LonLat c = field.parts.front().shell.at(2);
  const LonLat d = field.parts.front().shell.at(3);
  field.gates.push_back(Gate{"north", {(c.lon_deg + d.lon_deg) / 2, (c.lat_deg + d.lat_deg) / 2}, {}});
  PlanFile plan = written(field,
                          "[machine]\npreset = \"tractor-6m\"\nmin_turn_radius_m = 0.5\nbody_width_m = 4\n"
                          "[field]\nedge_margin_m = 0.05\n[headland]\npasses = 0\n");
  REQUIRE(std::ranges::none_of(plan.swaths, [](const SwathRecord& swath) { return swath.id == "1"; }));
  CHECK(text_of(verify(plan, std::nullopt)) == "");
  AbRecord& ab = plan.ab_lines.front();
  const double aside_deg = 1 / 111320.0;  // a metre, whichever way it runs
  for (LonLat* end : {&ab.a, &ab.b}) end->lat_deg += aside_deg, end->lon_deg += aside_deg;
  CHECK(text_of(verify(plan, std::nullopt)).find("swath_spacing") != std::string::npos);
}

TEST_CASE("every plan of ours passes the independent check", "[verify]") {
  const auto name =
      GENERATE("f1.geojson", "f6.geojson", "l_shape.geojson", "with_pond.geojson", "pole.geojson",
               "gates_obstacles.geojson", "narrow_neck.geojson", "two_parts.geojson");
  const std::string machine = GENERATE("robot-3m", "tractor-6m", "husky");
  const std::string corners = GENERATE("round", "fill");
  CAPTURE(name, machine, corners);
  const Field field = sample(name);
  const std::string job =
      "[machine]\npreset = \"" + machine + "\"\n[headland]\ncorners = \"" + corners + "\"\n";
  const auto planned = plan(field, job_of(settings_of_toml(job, "test")), Repair::notes_only, no_progress);
  if (!planned) return;  // narrower than the tractor needs
  const PlanFile file = plan_from_geojson(to_geojson(planned->file), "test");
  const Verdict verdict = verify(file, GivenField{.file = sample_file(name)});
  CHECK(text_of(verdict) == "");
  CHECK(verdict.covered_m2 > 0.5 * verdict.area_m2);
}

TEST_CASE("speeds' rounding adds up on the long straights of a slow machine without a fault", "[verify]") {
  const Field field = field_of_metres({{{{0, 0}, {130, 0}, {130, 12}, {0, 12}}, {}}});
  const PlanFile plan = written(field, "[machine]\npreset = \"husky\"\nwork_speed_mps = 0.100049\n");
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("of a thousand broken plans at least 99 % are rejected with the right code", "[mutants]") {
  Score all;
  std::map<std::string, Score> by_name;
  const std::vector<PlanFile> plans = originals();
  for (const PlanFile& original : plans) CHECK(text_of(verify(original, std::nullopt)) == "");
  for (const auto family : {mutations_of_pieces(), mutations_of_samples(), mutations_of_records(),
                            mutations_of_layout(), hidden_mutations()})
    for (const Mutation& mutation : family)
      for (std::size_t i = 0; i < plans.size(); ++i)
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
          Score one;
          score(plans[i], mutation, 100 * i + seed, one);
          all.mutants += one.mutants, all.rejected += one.rejected;
          by_name[mutation.name].mutants += one.mutants;
          by_name[mutation.name].rejected += one.rejected;
        }
  std::printf("%d mutants in %zu ways, %d rejected with the right code\n", all.mutants, by_name.size(),
              all.rejected);
  CHECK(by_name.size() >= 40);
  for (const auto& [name, tried] : by_name) {
    CAPTURE(name);
    CHECK(tried.mutants > 0);
    CHECK(tried.rejected >= 0.9 * tried.mutants);  // so that no check is missing whole
  }
  CHECK(all.mutants >= 1000);
  CHECK(all.rejected >= 0.99 * all.mutants);
}

TEST_CASE("a piece that turns round and round is refused before it is followed", "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\npreset = \"robot-3m\"\n");
  PieceRecord& piece = plan.trajectories.at(0).pieces.at(0);
  REQUIRE(piece.length_m > 20);
  SECTION("along a bend") { piece.sharpness_per_m2 = 3.5; }
  SECTION("on the spot") {
    piece.kind = "pivot";
    piece.length_m = 0;
    piece.angle_rad = 1e9;
    piece.duration_s = 1;
  }
  const Verdict verdict = verify(plan, std::nullopt);
  CHECK(std::ranges::count(verdict.findings, "piece", &Finding::code) == 1);
}

TEST_CASE("a piece or way longer than its block takes is refused before it is followed", "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\npreset = \"robot-3m\"\n");
  std::vector<PieceRecord>& pieces = plan.trajectories.at(0).pieces;
  PieceRecord round = pieces.at(0);
  SECTION("a piece") { pieces.at(0).length_m = 9e5; }
  SECTION("a piece far away") { pieces.at(0).x_m += 900; }
  SECTION("rounds with the tool up") {
    round.kind = "turn", round.ref.clear(), round.tool = 0;
    round.curvature_per_m = 0.5, round.length_m = 12.5;
    pieces.insert(pieces.end(), 50'000, round);
  }
  SECTION("rounds with the tool down") {
    round.curvature_per_m = 0.5, round.length_m = 12.5;
    pieces.insert(pieces.end(), 200, round);
  }
  const Verdict verdict = verify(plan, std::nullopt);
  REQUIRE(verdict.findings.size() == 1);
  CHECK(verdict.findings.front().code == "piece");
}

TEST_CASE("the same way for many robots, and a border that is a tangle, are refused before they are followed",
          "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\npreset = \"robot-3m\"\n");
  const TrajectoryRecord first = plan.trajectories.at(0);
  std::string code;
  SECTION("copies") {
    for (int robot = 2; robot < 60; ++robot) plan.trajectories.emplace_back(first).robot = robot;
    code = "block";
  }
  SECTION("all but copies") {
    for (int robot = 2; robot < 60; ++robot) {
      plan.trajectories.emplace_back(first).robot = robot;
      plan.trajectories.back().pieces.front().x_m += 1e-6 * robot;
    }
    code = "piece";
  }
  SECTION("a tangle") {
    Dice dice{7};
    LonLatLine& shell = plan.fields.at(0).parts.at(0).shell;
    const LonLat at = shell.front();
    for (int i = 0; i < 20'000; ++i)
      shell.push_back({at.lon_deg + dice.between(0, 1e-3), at.lat_deg + dice.between(0, 1e-3)});
    code = "field_shape";
  }
  const Verdict verdict = verify(plan, std::nullopt);
  REQUIRE(verdict.findings.size() == 1);
  CHECK(verdict.findings.front().code == code);
}

TEST_CASE("a tool that gets out is found where the body stays inside", "[verify]") {
  const auto rectangle = [](double in_m) {
    return Polygon{{{in_m, in_m}, {60 - in_m, in_m}, {60 - in_m, 40 - in_m}, {in_m, 40 - in_m}}, {}};
  };
  PlanFile plan = written(field_of_metres({rectangle(0)}), "[headland]\norder = \"last\"\n");
  plan.fields.at(0).parts.at(0).shell = polygon_of_metres(rectangle(0.45)).shell;  // the margin is 0.3 m
  const auto count = [verdict = verify(plan, std::nullopt)](const char* code) {
    return std::ranges::count(verdict.findings, code, &Finding::code);
  };
  CHECK(count("tool_outside") > 0);
}

TEST_CASE("strips left of an AB line are counted and lie where width, overlap and shift say", "[verify]") {
  const PlanFile plan = written(
      small_field(), "[layout]\nab = [10.0003, 50.0, 10.0003, 50.001]\nab_shift_m = 0.7\noverlap_m = 0.2\n");
  REQUIRE(std::ranges::any_of(plan.swaths, [](const SwathRecord& s) { return s.id.starts_with('L'); }));
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("pieces of a strip far from each other are in line though the AB line is short", "[verify]") {
  const int step = GENERATE(range(0, 12));  // the decimals of some AB lines point aside
  const double tower_m = 16.1 + 0.07 * step;
  const double high_m = 43 + 0.13 * step;
  CAPTURE(step);
  const Field field = field_of_metres({{{{0, 0},
                                         {1500, 0},
                                         {1500, 40},
                                         {1480, 40},
                                         {1480, 16},
                                         {tower_m, 16},
                                         {tower_m, high_m},
                                         {0, high_m}},
                                        {}}});
  const PlanFile plan = written(field, "[layout]\ndirection = 90\n");
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("only the gate that is driven through has to be wide enough", "[verify]") {
  PlanFile plan = written(sample("gates_obstacles.geojson"), "[route]\nstart = \"gate:2\"\n");
  REQUIRE(plan.gates.size() == 2);
  plan.gates[0].width_m = 1;
  CHECK(text_of(verify(plan, std::nullopt)) == "");
  std::swap(plan.gates[0].width_m, plan.gates[1].width_m);
  CHECK(text_of(verify(plan, std::nullopt)) != "");
}

TEST_CASE("a band worked along its borders passes whatever the rule for swaths", "[verify]") {
  const Field band = field_of_metres(
      {{{{0, 0}, {60, 0}, {100, 30}, {100, 90}, {94.6, 90}, {94.6, 32.7}, {58.2, 5.4}, {0, 5.4}}, {}}});
  const auto direction = GENERATE("edge", "p3", "40");
  const PlanFile plan = written(band, std::string{"[layout]\ndirection = \""} + direction + "\"\n");
  CHECK(plan.swaths.empty());
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("a swath bent by nothing keeps the edge margin all the same", "[verify]") {
  PlanFile plan = written(small_field(), "[headland]\npasses = 0\n[field]\nedge_margin_m = 0.3\n");
  const std::string margin = "\"edge_margin_m\":0.3";
  plan.job_json.replace(plan.job_json.find(margin), margin.size(), "\"edge_margin_m\":9.0");
  for (PieceRecord& piece : plan.trajectories.at(0).pieces)
    if (piece.kind == "swath") piece.curvature_per_m = 1e-12;
  const Verdict verdict = verify(plan, std::nullopt);
  CHECK(std::ranges::count(verdict.findings, "edge_margin", &Finding::code) > 0);
}

TEST_CASE("ways on the ground lead over the date line", "[verify]") {
  const Point way = verifying::ground_m({179.99999, -16}, {-179.99999, -16});
  CHECK(way.x_m == Approx(2.14).margin(0.01));
  CHECK(way.y_m == 0);
}

TEST_CASE("a robot that pivots into another one is found", "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\npreset = \"husky\"\nsafety_gap_m = 0.1\n");
  const double north_m = GENERATE(0.95, 1.2);  // at 0.95 m its corner comes within 2 cm
  const LonLat at = plan.origin;
  const auto standing = [&](int robot, double y_m, const std::vector<double>& headings) {
    TrajectoryRecord t;
    t.robot = robot;
    t.pieces = {PieceRecord{.kind = "wait", .y_m = y_m, .duration_s = 30}};
    t.duration_s = 30;
    t.heading_rad = headings;
    for (std::size_t i = 0; i < headings.size(); ++i)
      t.t_s.push_back(30.0 * static_cast<double>(i) / static_cast<double>(headings.size() - 1));
    t.line.assign(headings.size(), {at.lon_deg, at.lat_deg + y_m / 111'229});
    t.curvature_per_m = t.speed_mps = std::vector<double>(headings.size());
    t.tool = std::vector<int>(headings.size());
    return t;
  };
  plan.trajectories = {standing(1, 0, {0, 1.57, 3.14}), standing(2, north_m, {0, 0})};
  plan.trajectories.front().pieces.front().kind = "pivot";
  plan.trajectories.front().pieces.front().angle_rad = 3.14;
  const Verdict verdict = verify(plan, std::nullopt);
  CHECK(std::ranges::count(verdict.findings, "robots_too_close", &Finding::code) == (north_m < 1 ? 1 : 0));
}

TEST_CASE("robots are held apart by their tools too, however many there are", "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\nworking_width_m = 4\nsafety_gap_m = 0.1\n");
  const double aside_m = GENERATE(0.001, 3.0, 3.85, 4.05, 4.2);  // between axles that stand side by side
  const LonLat at = plan.origin;
  plan.trajectories.clear();
  const auto add = [&](int robot, double y_m) {
    TrajectoryRecord t;
    t.robot = robot;
    t.pieces = {PieceRecord{.kind = "wait", .y_m = y_m, .duration_s = 1000}};
    t.duration_s = 1000;
    t.t_s = {0, 1000};
    t.line.assign(2, {at.lon_deg, at.lat_deg + y_m / 111'229});
    t.heading_rad = t.curvature_per_m = t.speed_mps = {0, 0};
    t.tool = {0, 0};
    plan.trajectories.push_back(t);
  };
  const int robots = aside_m < 1 ? 300 : 2;
  for (int k = 0; k < robots; ++k) add(k + 1, k * aside_m);
  const auto found =
      std::ranges::count(verify(plan, std::nullopt).findings, "robots_too_close", &Finding::code);
  CHECK(found == (robots == 300 ? 5 : aside_m < 4.1 ? 1 : 0));
}

TEST_CASE("a headland pass beside a swath is no swath, one in its place is", "[verify]") {
  PlanFile plan = written(small_field(), "");
  const bool in_its_place = GENERATE(false, true);
  const SwathRecord swath = plan.swaths.at(plan.swaths.size() / 2);
  const double aside_deg = 0.4 * plan.trajectories.at(0).working_width_m / 111'229;
  plan.headland_passes.push_back({swath.block, "H99", 1, swath.line, swath.width_m});
  for (LonLat& p : plan.headland_passes.back().line) p.lat_deg += aside_deg;
  if (in_its_place) std::erase_if(plan.swaths, [&](const SwathRecord& s) { return s.id == swath.id; });
  const Verdict verdict = verify(plan, std::nullopt);
  const auto told_a_swath = [](const Finding& f) { return f.code == "line_kind" && mentions(f.what, "H99"); };
  CHECK(std::ranges::any_of(verdict.findings, told_a_swath) == in_its_place);
}

TEST_CASE("a pivot that does most of its turn between two samples in no time is found", "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\npreset = \"husky\"\n[headland]\npasses = 0\n");
  CHECK(text_of(verify(plan, std::nullopt)).empty());
  std::vector<double>& times = plan.trajectories.at(0).t_s;
  const std::vector<double>& headings = plan.trajectories.at(0).heading_rad;
  const std::vector<double>& speeds = plan.trajectories.at(0).speed_mps;
  std::size_t i = 1;
  while (i + 1 < times.size() && !(speeds[i - 1] == 0 && speeds[i] == 0 && speeds[i + 1] == 0 &&
                                   std::abs(headings[i + 1] - headings[i]) > 0.2))
    ++i;
  REQUIRE(i + 1 < times.size());
  const double middle = (times[i] + times[i + 1]) / 2;
  times[i] = middle - 1e-3, times[i + 1] = middle + 1e-3;
  const Verdict verdict = verify(plan, std::nullopt);
  CHECK(std::ranges::count(verdict.findings, "pivot_time", &Finding::code) > 0);
}

TEST_CASE("an obstacle on the way is found whatever block it is said to be of", "[verify]") {
  PlanFile plan = written(sample("f6.geojson"), "");
  const LonLatLine& line = plan.trajectories.at(0).line;
  const LonLat at = line.at(line.size() / 2);
  ObstacleRecord barn;
  barn.block = 99;
  barn.name = "barn";
  barn.what = "obstacle";
  for (const auto& [east, north] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
    barn.area.shell.push_back({at.lon_deg + 1e-4 * east, at.lat_deg + 1e-4 * north});
  plan.obstacles.push_back(barn);
  const Verdict verdict = verify(plan, std::nullopt);
  CHECK(std::ranges::count(verdict.findings, "body_obstacle", &Finding::code) > 0);
}

TEST_CASE("a fence thinner than what is allowed for roundings is found on the way", "[verify]") {
  PlanFile plan = written(small_field(), "[field]\nobstacle_clearance_m = 0\n");
  CHECK(text_of(verify(plan, std::nullopt)).empty());
  ObstacleRecord fence;
  fence.block = 1;
  fence.what = "obstacle";
  fence.area.shell = polygon_of_metres({{{10, 20}, {50, 20}, {50, 20.015}, {10, 20.015}}, {}}).shell;
  plan.obstacles.push_back(fence);
  const Verdict verdict = verify(plan, std::nullopt);
  CHECK(std::ranges::count(verdict.findings, "body_obstacle", &Finding::code) > 0);
}

TEST_CASE("along a fence that stands on the border its own clearance is kept, not the edge margin",
          "[verify]") {
  Field field = field_of_metres({{{{0, 0}, {250, 0}, {250, 180}, {0, 180}}, {}}});
  field.obstacles.push_back({"fence", ObstacleKind::obstacle,
                             polygon_of_metres({{{0, 90}, {200, 90}, {200, 90.02}, {0, 90.02}}, {}})});
  const std::string job = "[machine]\npreset = \"tractor-12m\"\n[field]\nobstacle_clearance_m = ";
  CHECK(text_of(verify(written(field, job + "0\n"), std::nullopt)) == "");
  PlanFile nearer = written(field, job + "0.3\n");
  CHECK(text_of(verify(nearer, std::nullopt)) == "");
  for (CellRecord& cell : nearer.cells)
    for (LonLatArea& part : cell.parts)
      for (LonLat& p : part.shell) p.lat_deg += 1e-6;
  CHECK(text_of(verify(nearer, std::nullopt)).find("a cell lies") != std::string::npos);
}

TEST_CASE("ground that is ten widths wide is worked by ten strips, a hair more or less", "[verify]") {
  const double more_m = GENERATE(-0.005, -1e-4, -1e-6, 0.0, 1e-6, 1e-4, 0.005, 0.02);
  CAPTURE(more_m);
  const double high = 2 * (0.3 + 3 + 2.98) + 10 * 3 + more_m;
  const Field field = field_of_metres({{{{0, 0}, {200, 0}, {200, high}, {0, high}}, {}}});
  const PlanFile plan = written(field, "[machine]\npreset = \"robot-3m\"\n[headland]\npasses = 2\n");
  CHECK(plan.swaths.size() == (more_m > 0.01 ? 11 : 10));
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("a hole too thin to be seen keeps its own clearance, not the edge margin", "[verify]") {
  const double thin_m = GENERATE(0.002, 0.008, 0.015, 0.03);
  CAPTURE(thin_m);
  const Field field = field_of_metres({{{{0, 0}, {200, 0}, {200, 120}, {0, 120}},
                                        {{{60, 60}, {60, 60 + thin_m}, {140, 60 + thin_m}, {140, 60}}}}});
  const std::string job = "[machine]\npreset = \"robot-3m\"\n[field]\nobstacle_clearance_m = 0\n";
  CHECK(text_of(verify(written(field, job), std::nullopt)) == "");
}

TEST_CASE("work that begins where other work ends is gone on with, however they are rounded", "[verify]") {
  const double east_deg = GENERATE(299.0, 299.5, 300.0) / 68677;
  const double north_deg = 3.7 / 111267;
  Field field;
  field.parts.push_back(
      {{{5.1, 52.1}, {5.1 + east_deg, 52.1}, {5.1 + east_deg, 52.1 + north_deg}, {5.1, 52.1 + north_deg}},
       {}});
  const PlanFile plan = written(field, "[machine]\npreset = \"amiga\"\nfront_m = 7.5\n");
  REQUIRE(
      std::ranges::any_of(plan.swaths, [](const SwathRecord& swath) { return swath.id.starts_with('P'); }));
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("a second robot on the first one's way is found, with no gap asked for and without names of lines",
          "[verify]") {
  PlanFile plan = written(sample("f6.geojson"), "[machine]\nsafety_gap_m = 0\n");
  TrajectoryRecord other = plan.trajectories.at(0);
  other.robot = 2;
  for (PieceRecord& piece : other.pieces) piece.ref.clear();
  plan.trajectories.push_back(other);
  const Verdict verdict = verify(plan, std::nullopt);
  for (const char* code : {"robots_too_close", "unknown_line"})
    CHECK(std::ranges::count(verdict.findings, code, &Finding::code) > 0);
}

TEST_CASE("the one place where a long drive comes close to a pole is among those to look at", "[verify]") {
  const double x_m = GENERATE(124.0, 130.0, 136.0);
  const Field field = field_of_metres({{{{0, 0}, {200, 0}, {200, 120}, {0, 120}},
                                        {{{x_m, 60}, {x_m, 60.4}, {x_m + 0.4, 60.4}, {x_m + 0.4, 60}}}}});
  const PlanFile plan = written(field, "[field]\nobstacle_clearance_m = 0.1\n[headland]\norder = \"none\"\n");
  const WatchList list = watch_list(plan);
  REQUIRE(list.closest.size() == 10);
  CHECK(std::ranges::any_of(list.closest, [](const WatchPlace& place) {
    return place.what == "obstacle" && place.measure_m < 0.3;
  }));
}

TEST_CASE("what is driven in the last half millimetre before a stop is no standing", "[verify]") {
  PlanFile plan = written(small_field(), "[machine]\npreset = \"husky\"\n[headland]\ncorners = \"fill\"\n");
  int stops = 0;
  for (TrajectoryRecord& t : plan.trajectories)
    for (std::size_t i = t.t_s.size() - 1; i > 0; --i) {
      const double before_s = t.t_s[i] - t.t_s[i - 1];
      if (t.speed_mps[i] != 0 || t.speed_mps[i - 1] < 0.1 || t.tool[i - 1] == 0) continue;
      const double brakes_mps2 = t.speed_mps[i - 1] / before_s;
      const double last_s = std::sqrt(2 * 4e-4 / brakes_mps2);
      const double left = last_s * last_s / (before_s * before_s);  // of the way
      const LonLat from = t.line[i - 1];
      const LonLat to = t.line[i];
      const auto at = static_cast<std::ptrdiff_t>(i);
      t.line.insert(t.line.begin() + at, {to.lon_deg + left * (from.lon_deg - to.lon_deg),
                                          to.lat_deg + left * (from.lat_deg - to.lat_deg)});
      t.t_s.insert(t.t_s.begin() + at, t.t_s[i] - last_s);
      t.speed_mps.insert(t.speed_mps.begin() + at, brakes_mps2 * last_s);
      t.heading_rad.insert(t.heading_rad.begin() + at, t.heading_rad[i]);
      t.curvature_per_m.insert(t.curvature_per_m.begin() + at, t.curvature_per_m[i]);
      t.tool.insert(t.tool.begin() + at, t.tool[i - 1]);
      ++stops;
    }
  REQUIRE(stops > 5);
  CHECK(text_of(verify(plan, std::nullopt)) == "");
}

TEST_CASE("the list of places to look at names ten approaches and ten bends", "[verify]") {
  const WatchList list = watch_list(written(sample("with_pond.geojson"), ""));
  REQUIRE(list.closest.size() == 10);
  REQUIRE(list.tightest.size() == 10);
  for (std::size_t i = 1; i < 10; ++i) {
    CHECK(list.closest[i - 1].measure_m <= list.closest[i].measure_m);
    CHECK(list.tightest[i - 1].measure_m <= list.tightest[i].measure_m);
  }
  CHECK(list.closest[0].measure_m > -0.011);
  CHECK(list.tightest[0].measure_m == Approx(1.8).margin(1e-3));  // tan(45 degrees) / 1.8 m
}

TEST_CASE("a frame by code is known for the one that the job names", "[verify]") {
  const std::string code = GENERATE("EPSG:32632", "EPSG:25832", "EPSG:31467");
  CAPTURE(code);
  PlanFile plan = written(small_field(), "[frame]\ncrs = \"" + code + "\"\n");
  CHECK(text_of(verify(plan, std::nullopt)) == "");
  const std::size_t at = plan.job_json.find(code);
  REQUIRE(at != std::string::npos);
  plan.job_json.replace(at, code.size(), "auto");
  CHECK_THAT(text_of(verify(plan, std::nullopt)), Catch::StartsWith("frame"));
}

TEST_CASE("work taken out of a plan is found although every record is consistent", "[verify]") {
  PlanFile file = written(sample("l_shape.geojson"), "");
  CHECK(text_of(verify(file, std::nullopt)).find("left_unworked") == std::string::npos);
  std::erase_if(file.swaths, [](const SwathRecord&) { return true; });
  for (TrajectoryRecord& trajectory : file.trajectories)
    for (PieceRecord& piece : trajectory.pieces)
      if (piece.kind == "swath") {
        piece.kind = "transfer";
        piece.ref.clear();
        piece.tool = 0;
      }
  CHECK(text_of(verify(file, std::nullopt)).find("left_unworked") != std::string::npos);
  file.warnings.emplace_back("Block 1 is only partly planned: 99.0 % of it is covered.");
  CHECK(text_of(verify(file, std::nullopt)).find("left_unworked") != std::string::npos);
}
