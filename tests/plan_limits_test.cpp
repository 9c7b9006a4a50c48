// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "files.hpp"
#include "motion_drives.hpp"
#include "plan_check.hpp"
#include "selion/field/read.hpp"
#include "selion/motion/timed_turn.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

Field paper_field(const std::string& name) {
  std::istringstream nothing;
  return read_fields(data_dir() / "fields" / (name + ".geojson"), {}, nothing).at(0);
}

/// What the records of a drive tell.
std::vector<Leg> legs_of(const TrajectoryRecord& trajectory, const Machine& machine) {
  std::vector<Leg> legs;
  for (const PieceRecord& p : trajectory.pieces) {
    const Curve curve{{p.x_m, p.y_m}, p.heading_rad, p.curvature_per_m, p.sharpness_per_m2, p.length_m};
    const double cap = p.tool == 1 ? machine.work_speed_mps : turn_cap_mps(machine, curve);
    legs.push_back({{curve, p.gear > 0 ? Gear::forward : Gear::reverse, p.angle_rad.value_or(0)},
                    cap,
                    p.tool == 1,
                    p.duration_s.value_or(0)});
  }
  return legs;
}

}  // namespace

TEST_CASE("every plan of the paper's fields keeps every limit on its whole way", "[plan][limits]") {
  const auto name = GENERATE("f1", "f2", "f3", "f4", "f5", "f6");
  const auto machine =
      GENERATE("preset = \"robot-3m\"", "preset = \"tractor-6m\"", "preset = \"husky\"\nworking_width_m = 3",
               "preset = \"p3\"\nworking_width_m = 4\nmax_steer_deg = 18",
               "preset = \"p3\"\nworking_width_m = 6\nturn_speed_mps = 1\nwork_speed_mps = 3.5");
  CAPTURE(name, machine);
  const Job job = job_of(settings_of_toml(std::string{"[machine]\n"} + machine + "\n", "test"));

  const auto planned = plan(paper_field(name), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  CHECK(faults_of(*planned, job.machine) == std::vector<std::string>{});
  for (const TrajectoryRecord& trajectory : planned->file.trajectories) {
    const std::vector<Leg> legs = legs_of(trajectory, job.machine);
    const std::vector<Sample> samples = drive(legs, job.machine);
    CHECK(samples.back().t_s == Approx(trajectory.duration_s).epsilon(1e-9));  // the same drive
    check_within(limit_use(legs, samples, job.machine));
  }
}

TEST_CASE("nothing is worked on a curve tighter than the tool bears", "[plan][limits]") {
  const auto name = GENERATE("f2", "f5");
  const auto corners = GENERATE("round", "fill");
  CAPTURE(name, corners);
  const Job job = job_of(settings_of_toml(
      std::string{"[machine]\npreset = \"p3\"\nworking_width_m = 4\nmax_steer_deg = 18\nmin_work_radius_m = "
                  "9\n[headland]\ncorners = \""} +
          corners + "\"\n",
      "test"));

  const auto planned = plan(paper_field(name), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  CHECK(faults_of(*planned, job.machine) == std::vector<std::string>{});
  double tightest_down = 0;
  double tightest_up = 0;
  for (const TrajectoryRecord& trajectory : planned->file.trajectories)
    for (const PieceRecord& p : trajectory.pieces)
      (p.tool == 1 ? tightest_down : tightest_up) =
          std::max(p.tool == 1 ? tightest_down : tightest_up, std::abs(p.curvature_per_m));
  CHECK(tightest_down == Approx(1.0 / 9).epsilon(0.02));  // the limit is used
  CHECK(tightest_up > 0.2);
}

TEST_CASE("a run-in longer than the headland is deep is cut short at the border", "[plan][limits]") {
  const auto name = GENERATE("f5", "f6");
  CAPTURE(name);
  const Job job =
      job_of(settings_of_toml("[machine]\npreset = \"p3\"\nworking_width_m = 4\nmax_steer_deg = 18\nrun_in_m "
                              "= 18\ntool_lower_s = 3\n[headland]\npasses = 3\n",
                              "test"));

  const auto planned = plan(paper_field(name), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(100 * block.covered_m2 / block.area_m2 > 98.5);  // no swath is left out for its run-in
  CHECK(faults_of(*planned, job.machine) == std::vector<std::string>{});
}

TEST_CASE("a turn forwards at lower speed is driven where one with stops takes longer", "[plan][route]") {
  const Job job = job_of(settings_of_toml("[machine]\npreset = \"robot-3m\"\n", "test"));
  const auto planned = plan(paper_field("f1"), job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  REQUIRE(planned->blocks.size() == 1);
  CHECK(planned->blocks.front().turn_s < 1140);  // 1144 s with fishtails from swath 4 to 5 and from 6 to 7
}

TEST_CASE("a machine that may turn faster takes no longer", "[plan][limits]") {
  const auto duration_at_s = [](const std::string& turn_speed) {
    const Job job =
        job_of(settings_of_toml("[machine]\nmax_steer_rate_deg_s = 15\nmax_lateral_mps2 = 2\nmax_speed_mps = "
                                "5\nwork_speed_mps = 2.5\n"
                                "turn_speed_mps = " +
                                    turn_speed + "\n[headland]\npasses = 4\n",
                                "test"));
    const auto planned = plan(paper_field("f1"), job, Repair::notes_only, no_progress);
    REQUIRE(planned.has_value());
    CHECK(faults_of(*planned, job.machine) == std::vector<std::string>{});
    return planned->file.trajectories.at(0).duration_s;
  };
  const double slowest_s = duration_at_s("1");
  const double slow_s = duration_at_s("3");
  CHECK(slow_s < slowest_s);
  CHECK(duration_at_s("5") < 1.005 * slow_s);  // the speeds tried are a tenth apart
}
