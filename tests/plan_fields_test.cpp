// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <filesystem>
#include <sstream>

#include "field_samples.hpp"
#include "files.hpp"
#include "plan_check.hpp"
#include "selion/core/error.hpp"
#include "selion/core/units.hpp"
#include "selion/field/read.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

Field read_one(const std::filesystem::path& file) {
  std::istringstream nothing;
  return read_fields(file, {}, nothing).at(0);
}

Field sample(const std::string& name) { return read_one(data_dir() / "fields" / name); }

Job job_of_toml(const std::string& text) { return job_of(settings_of_toml(text, "test")); }

std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

}  // namespace

TEST_CASE("the paper's fields are covered to 99 % with little worked twice", "[plan]") {
  const auto name =
      GENERATE("f1.geojson", "f2.geojson", "f3.geojson", "f4.geojson", "f5.geojson", "f6.geojson");
  CAPTURE(name);
  const Job job = job_of_toml("[machine]\npreset = \"p3\"\nworking_width_m = 4\nmax_steer_deg = 18\n");

  const auto planned = plan(sample(name), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.99 * block.area_m2);
  CHECK(block.twice.total_m2() <= 0.06 * block.area_m2);
  CHECK(joined(faults_of(*planned, job.machine)) == "");
  double uncovered = 0;
  for (const Uncovered& part : block.uncovered) uncovered += part.area_m2;
  CHECK(uncovered == Approx(block.area_m2 - block.covered_m2).margin(0.002 * block.area_m2));
}

TEST_CASE("driving forwards only, a body as wide as its tool covers the paper's fields in good time",
          "[plan]") {
  struct Case {
    const char* name;
    double covered_percent;
    double time_ratio;
  };
  const auto field = GENERATE(values<Case>({{"f1.geojson", 99.6, 1.23},
                                            {"f2.geojson", 99.7, 1.24},
                                            {"f3.geojson", 99.6, 1.19},
                                            {"f4.geojson", 99.8, 1.21},
                                            {"f5.geojson", 99.6, 1.29},
                                            {"f6.geojson", 99.3, 1.35}}));
  CAPTURE(field.name);
  const Job job = job_of_toml(
      "[machine]\npreset = \"p3\"\nworking_width_m = 4\nbody_width_m = 4\nfront_m = 2.4\nrear_m = 0.6\n"
      "max_steer_deg = 18\nmax_lateral_mps2 = 1.5\nwork_speed_mps = 3.5\nmay_reverse = false\n");

  const auto planned = plan(sample(field.name), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(100 * block.covered_m2 / block.area_m2 >= field.covered_percent);
  const double total_s = block.work_s + block.turn_s + block.transfer_s;
  CHECK(total_s <= field.time_ratio * block.covered_m2 / (4 * 3.5));
  CHECK(block.reverse_m == 0);
  CHECK(joined(faults_of(*planned, job.machine)) == "");
}

TEST_CASE("every preset drives every field of our own without a fault", "[plan]") {
  const auto name =
      GENERATE("l_shape.geojson", "u_shape.geojson", "with_pond.geojson", "slanted.geojson",
               "gates_obstacles.geojson", "two_parts.geojson", "pole.geojson", "narrow_neck.geojson");
  const auto preset = GENERATE("robot-3m", "amiga", "tractor-6m");
  CAPTURE(name, preset);
  const Job job = job_of_toml(std::string{"[machine]\npreset = \""} + preset + "\"\n");

  const auto planned = plan(sample(name), job, Repair::notes_only, no_progress);

  if (!planned) {
    CHECK(planned.error().reason.find(" m") != std::string::npos);
    return;
  }
  CHECK(joined(faults_of(*planned, job.machine)) == "");
}

TEST_CASE("a heading that was asked for is driven that way, not turned about", "[plan]") {
  const double bearing = GENERATE(0.0, 33.3, 90.0, 270.0);
  const Job job = job_of_toml("[layout]\ndirection = \"" + std::to_string(bearing) + "\"\n");
  const auto planned = plan(sample("f1.geojson"), job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  const double off = planned->blocks.at(0).bearing_deg - bearing;
  CHECK(std::abs(std::remainder(off, 360)) < 0.01);  // the meridians of A and of the field's centre differ
}

TEST_CASE("a gate or an AB line that cannot be meant is an error", "[plan]") {
  const auto refusal = [](const std::string& field, const std::string& toml) {
    try {
      static_cast<void>(plan(sample(field), job_of_toml(toml), Repair::notes_only, no_progress));
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  CHECK(refusal("f1.geojson", "[route]\nstart = \"gate:1\"\n").find("it has none") != std::string::npos);
  CHECK(refusal("gates_obstacles.geojson", "[route]\nstart = \"gate:7\"\n").find("gate:2 (east gate)") !=
        std::string::npos);
  CHECK(refusal("f1.geojson", "[layout]\nab = [46.3, 3.4, 46.31, 3.4]\n").find("swapped") !=
        std::string::npos);
  CHECK(refusal("f1.geojson", "[frame]\ncrs = \"EPSG:32760\"\n").find("stretches") != std::string::npos);
}

TEST_CASE("a part in the hole of another part is planned too", "[plan]") {
  const auto square = [](double from, double to) {
    return Ring{{from, from}, {to, from}, {to, to}, {from, to}};
  };
  Ring hole = square(50, 250);
  std::reverse(hole.begin(), hole.end());
  const auto planned = plan(field_of_metres({{square(0, 300), {hole}}, {square(75, 225), {}}}), Job{},
                            Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  REQUIRE(planned->blocks.size() == 2);
  CHECK(planned->blocks[1].area_m2 == Approx(150 * 150).epsilon(1e-3));
  CHECK(planned->blocks[1].covered_m2 >= 0.95 * planned->blocks[1].area_m2);
}

TEST_CASE("a plan names the obstacles that it keeps clear of", "[plan]") {
  const auto planned = plan(sample("gates_obstacles.geojson"), Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  std::vector<std::string> told;
  for (const ObstacleRecord& obstacle : planned->file.obstacles)
    told.push_back(obstacle.what + " " + obstacle.name);
  CHECK(told == std::vector<std::string>{"obstacle barn", "no_go orchids", "water pond"});
}

TEST_CASE("arms too narrow to turn in are worked, backing in or out", "[plan]") {
  Ring comb{{0, 0}, {100, 0}, {100, 120}};  // teeth 6 m wide and 90 m deep
  for (int i = 4; i >= 0; --i) {
    const double x = 20.0 * i;
    for (const Point p : {Point{x + 14, 120}, Point{x + 14, 30}, Point{x, 30}, Point{x, 120}})
      comb.push_back(p);
  }
  comb.pop_back();  // no tooth left of the last gap
  const Ring sliver{{0, 0}, {300, 0}, {0, 40}};
  const Ring shell = GENERATE_COPY(comb, sliver);
  CAPTURE(shell.size());

  const auto planned = plan(field_of_metres({{shell, {}}}), Job{}, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, Machine{})) == "");
  CHECK(planned->blocks.at(0).covered_m2 >= 0.88 * planned->blocks.at(0).area_m2);
}

TEST_CASE("no piece is a crumb and no two samples share a time", "[plan]") {
  Field field =
      field_of_metres({{{{0, 0}, {160, 0}, {160, 120}, {0, 120}}, {{{60, 6}, {60, 20}, {90, 20}, {90, 6}}}}});
  const auto planned = plan(field, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, Machine{})) == "");
  for (const TrajectoryRecord& t : planned->file.trajectories)
    for (const PieceRecord& piece : t.pieces) CHECK((piece.length_m >= 5e-7 || piece.duration_s));
}

TEST_CASE("a machine that may not reverse never does", "[plan]") {
  const Job job = job_of_toml("[machine]\npreset = \"robot-3m\"\nmay_reverse = false\n");
  const auto planned = plan(sample("l_shape.geojson"), job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  for (const TrajectoryRecord& t : planned->file.trajectories)
    for (const PieceRecord& piece : t.pieces) CHECK(piece.gear == 1);
}

TEST_CASE("an AB line fixes heading and phase", "[plan]") {
  const Field field = sample("f2.geojson");
  const LonLat at = field.parts.at(0).shell.at(0);
  std::ostringstream toml;
  toml.precision(12);
  toml << "[layout]\nab = [" << at.lon_deg << ", " << at.lat_deg << ", " << at.lon_deg << ", "
       << at.lat_deg + 0.001 << "]\n";
  const auto planned = plan(field, job_of_toml(toml.str()), Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(planned->blocks.at(0).bearing_deg == Approx(0).margin(1e-4));
  for (const SwathRecord& swath : planned->file.swaths) {
    if (swath.cell.empty()) continue;  // pocket pieces follow their own direction
    const double east_m =
        (swath.line.at(0).lon_deg - at.lon_deg) * 111320 * std::cos(at.lat_deg * 0.0174532925199);
    const double passes = east_m / swath.width_m;
    CHECK(std::abs(passes - std::round(passes)) * swath.width_m < 0.5);
  }
}

TEST_CASE("a strip too narrow for two headland passes is planned inside one", "[plan]") {
  const Field strip = field_of_metres({{{{0, 0}, {300, 0}, {300, 11}, {0, 11}}, {}}});
  const auto planned = plan(strip, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, Machine{})) == "");
  CHECK(planned->blocks.at(0).headland_passes == 1);
  CHECK(planned->blocks.at(0).covered_m2 >= 0.9 * planned->blocks.at(0).area_m2);
  CHECK(joined(planned->notes).find("1 headland pass instead of the 2 that turns need") != std::string::npos);

  const Job two = job_of_toml("[headland]\npasses = 2\n");  // as told: no fewer
  const auto refused = plan(strip, two, Repair::notes_only, no_progress);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().reason.find("the headlands need 12.6 m of width") != std::string::npos);
  CHECK(refused.error().reason.find("the block is 11.0 m wide") != std::string::npos);
}

TEST_CASE("the one swath of a bent band little wider than the machine lies in its middle", "[plan]") {
  const Field band = field_of_metres({{{{0, 0}, {30, 0.8}, {60, 0}, {60, 4.6}, {30, 5.4}, {0, 4.6}}, {}}});
  const auto planned = plan(band, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, Machine{})) == "");
  CHECK(planned->blocks.at(0).covered_m2 >= 0.6 * planned->blocks.at(0).area_m2);
}

TEST_CASE("a band that bends is worked along its borders where swaths cover less", "[plan]") {
  const Field band = field_of_metres(
      {{{{0, 0}, {60, 0}, {100, 30}, {100, 90}, {94.6, 90}, {94.6, 32.7}, {58.2, 5.4}, {0, 5.4}}, {}}});
  const auto planned = plan(band, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, Machine{})) == "");
  CHECK(planned->blocks.at(0).swaths == 0);
  CHECK(planned->blocks.at(0).covered_m2 >= 0.8 * planned->blocks.at(0).area_m2);
  CHECK(joined(planned->notes).find("worked along its borders") != std::string::npos);
}

TEST_CASE("a pass along a band is driven through its bends", "[plan]") {
  const double spaced_m = GENERATE(2.5, 20.0);
  CAPTURE(spaced_m);
  constexpr double kRadius_m = 1500;
  constexpr double kWide_m = 13;
  Ring outer;
  Ring inner;
  for (double s = 0; s <= 430; s += spaced_m) {
    const double a = s / kRadius_m;
    outer.push_back({kRadius_m * std::sin(a), kRadius_m * (1 - std::cos(a))});
    inner.push_back({(kRadius_m - kWide_m) * std::sin(a), kRadius_m - (kRadius_m - kWide_m) * std::cos(a)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  const Job job = job_of_toml("[machine]\npreset = \"tractor-6m\"\n");
  const auto planned = plan(field_of_metres({{outer, {}}}), job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, job.machine)) == "");
  CHECK(planned->blocks.at(0).covered_m2 >= 0.9 * planned->blocks.at(0).area_m2);
  CHECK(planned->file.headland_passes.size() <= 8);
}

TEST_CASE("an arm too narrow to go round in is worked along its sides, not across", "[plan]") {
  const double wide_m = GENERATE(5.2, 7.2);
  CAPTURE(wide_m);
  const Field field =
      field_of_metres({{{{0, 0}, {160, 0}, {160, wide_m}, {40, wide_m}, {40, 90}, {0, 90}}, {}}});
  const auto planned = plan(field, job_of_toml("[layout]\ndirection = 0\n"), Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, Machine{})) == "");
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.95 * block.area_m2);
  CHECK(block.turns < 40);
  for (const SwathRecord& swath : planned->file.swaths)
    if (!swath.cell.empty()) CHECK(swath.length_m >= swath.width_m);
}

TEST_CASE("a tool ahead of the axle needs no deep headland", "[plan]") {
  const Field field = field_of_metres({{{{0, 0}, {60, 0}, {60, 90}, {0, 90}}, {}}});
  const std::string machine =
      GENERATE("preset = \"p3\"\ntool_x_m = 2.4\n", "preset = \"robot-3m\"\ntool_x_m = 2\n");
  const Job job = job_of_toml("[machine]\n" + machine + "[headland]\npasses = 1\n");
  const auto planned = plan(field, job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, job.machine)) == "");
  CHECK(planned->blocks.at(0).covered_m2 >= 0.97 * planned->blocks.at(0).area_m2);
}

TEST_CASE("what is too narrow for one swath is refused by width", "[plan]") {
  const Field path = field_of_metres({{{{0, 0}, {300, 0}, {300, 3.4}, {0, 3.4}}, {}}});
  const auto planned = plan(path, Job{}, Repair::notes_only, no_progress);
  REQUIRE_FALSE(planned.has_value());
  CHECK(planned.error().reason.find("a swath needs straight ground 3.6 m wide") != std::string::npos);
  CHECK(planned.error().reason.find("the block is 3.4 m wide") != std::string::npos);
}

TEST_CASE("a refusal names the width that is missing, or that it is not width", "[plan]") {
  const auto why = [](const Ring& shell, const std::string& job) {
    const auto planned =
        plan(field_of_metres({{shell, {}}}), job_of_toml(job), Repair::notes_only, no_progress);
    return planned ? std::string{"planned"} : planned.error().reason;
  };
  const Ring plus{{0, 30},  {30, 30}, {30, 0},  {60, 0},  {60, 30}, {90, 30},
                  {90, 60}, {60, 60}, {60, 90}, {30, 90}, {30, 60}, {0, 60}};
  CHECK(mentions(why(plus, "[headland]\npasses = 5\n"), "no swath fits; the block is 42.4 m wide"));
  const Ring strip{{0, 0}, {430, 0}, {430, 13}, {0, 13}};
  CHECK(mentions(why(strip, "[machine]\npreset = \"tractor-6m\"\nmay_reverse = false\n"),
                 "a machine that may not reverse gets into or out of no swath"));
}

TEST_CASE("blocks on both sides of a short neck share no ground", "[plan]") {
  const double neck_m = GENERATE(0.5, 1.5, 2.5);
  CAPTURE(neck_m);
  const double low = 15 - 1, high = 15 + 1, end = 40 + neck_m;  // two squares and a neck 2 m wide
  const Field field = field_of_metres({{{{0, 0},
                                         {40, 0},
                                         {40, low},
                                         {end, low},
                                         {end, 0},
                                         {end + 40, 0},
                                         {end + 40, 30},
                                         {end, 30},
                                         {end, high},
                                         {40, high},
                                         {40, 30},
                                         {0, 30}},
                                        {}}});
  const auto planned = plan(field, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  REQUIRE(planned->blocks.size() == 2);
  const double whole_m2 = 2 * 40 * 30 + 2 * neck_m;
  CHECK(planned->blocks[0].area_m2 + planned->blocks[1].area_m2 == Approx(whole_m2).margin(0.05));
}

TEST_CASE("the same field and job give the same bytes", "[plan]") {
  const auto once = plan(sample("with_pond.geojson"), Job{}, Repair::notes_only, no_progress);
  const auto again = plan(sample("with_pond.geojson"), Job{}, Repair::notes_only, no_progress);
  REQUIRE(once.has_value());
  CHECK(to_geojson(once->file) == to_geojson(again->file));
  CHECK(to_geojson(plan_from_geojson(to_geojson(once->file), "test")) == to_geojson(once->file));
}

TEST_CASE("an obstacle beside a field that falls into blocks is named in the plan that keeps off it",
          "[plan]") {
  Field field = field_of_metres({{{{0, 0}, {60, 0}, {31, 40}, {60, 80}, {0, 80}, {29, 40}}, {}}});
  const Field pole = field_of_metres({{{{29.5, -1}, {30.5, -1}, {30.5, -0.5}, {29.5, -0.5}}, {}}});
  field.obstacles.push_back({"pole", ObstacleKind::obstacle, pole.parts.at(0)});
  const auto planned = plan(field, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  REQUIRE(planned->blocks.size() > 1);
  REQUIRE(planned->file.obstacles.size() == 1);
  CHECK(planned->file.obstacles.front().name == "pole");
}

TEST_CASE("a run-in keeps a machine out of no swath that it reaches without", "[plan]") {
  const Field field = field_of_metres({{{{0, 0}, {60, 0}, {60, 90}, {0, 90}}, {}}});
  const std::string ahead = "[machine]\nmay_reverse = false\n";
  const std::string one_pass = "[headland]\npasses = 1\n";
  const auto without = plan(field, job_of_toml(ahead + one_pass), Repair::notes_only, no_progress);
  REQUIRE(without.has_value());
  for (const std::string run_in : {"0.5", "3"}) {
    const Job job = job_of_toml(ahead + "run_in_m = " + run_in + "\n" + one_pass);
    const auto planned = plan(field, job, Repair::notes_only, no_progress);
    REQUIRE(planned.has_value());
    CHECK(joined(faults_of(*planned, job.machine)) == "");
    CHECK(planned->blocks.at(0).covered_m2 > without->blocks.at(0).covered_m2 - 20);
  }
}

TEST_CASE("a machine backs over no swath where the way forwards takes hardly longer", "[plan]") {
  const Field field = sample("l_shape.geojson");
  const auto planned = plan(field, Job{}, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  double run_m = 0;
  double longest_m = 0;
  for (const TrajectoryRecord& trajectory : planned->file.trajectories)
    for (const PieceRecord& piece : trajectory.pieces) {
      run_m = piece.gear < 0 ? run_m + piece.length_m : 0;
      longest_m = std::max(longest_m, run_m);
    }
  CHECK(longest_m < 20);
}

TEST_CASE("a machine that pivots works a field without a headland by backing a little way from the border",
          "[plan]") {
  const Field field = field_of_metres({{{{0, 0}, {40, 0}, {40, 60}, {0, 60}}, {}}});
  const Job job = job_of_toml("[machine]\npreset = \"husky\"\n[headland]\npasses = 0\n");
  const auto planned = plan(field, job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(joined(faults_of(*planned, job.machine)) == "");
  CHECK(planned->blocks.at(0).covered_m2 > 0.96 * planned->blocks.at(0).area_m2);
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.turn_m + block.transfer_m < 0.3 * block.work_m);
}

TEST_CASE("a long way between work leads no farther round than it must", "[plan]") {
  const Job job = job_of_toml(
      "[machine]\npreset = \"tractor-6m\"\nmin_turn_radius_m = 6\n"
      "[field]\nedge_margin_m = 0.05\nobstacle_clearance_m = 0.05\n");
  const auto planned = plan(sample("f3.geojson"), job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  double longest_m = 0;
  double way_m = 0;
  for (const TrajectoryRecord& trajectory : planned->file.trajectories)
    for (const PieceRecord& piece : trajectory.pieces) {
      way_m = piece.ref.empty() ? way_m + piece.length_m : 0;
      longest_m = std::max(longest_m, way_m);
    }
  CHECK(longest_m > 400);  // from the far corner to what is left at the border
  CHECK(longest_m < 470);
}

TEST_CASE("no line is driven twice for what lies beyond its ends", "[plan]") {
  const double wide_m = GENERATE(8.0, 10.0);
  const double turned_deg = GENERATE(20, 25, 45, 70);
  CAPTURE(wide_m, turned_deg);
  const Point along = unit(radians_of_degrees(turned_deg));
  const Point up = wide_m * left_of(along);
  const Field field = field_of_metres({{{{0, 0}, 200 * along, 200 * along + up, up}, {}}});
  const Job job = job_of_toml("[machine]\nmay_reverse = false\n[headland]\npasses = 0\n");
  const auto planned = plan(field, job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  const auto& swaths = planned->file.swaths;
  for (std::size_t i = 0; i < swaths.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      CAPTURE(swaths[i].id, swaths[k].id);
      CHECK_FALSE(swaths[i].line == swaths[k].line);
    }
}
