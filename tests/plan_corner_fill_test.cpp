// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <filesystem>
#include <sstream>

#include "files.hpp"
#include "plan_check.hpp"
#include "selion/field/read.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

Plan planned(const std::string& name, const std::string& machine, const std::string& headland) {
  std::istringstream nothing;
  const auto file = data_dir() / "fields" / name;
  const Job job = job_of(settings_of_toml("[machine]\n" + machine + "[headland]\n" + headland, "test"));
  auto plan = selion::plan(read_fields(file, {}, nothing).at(0), job, Repair::notes_only, no_progress);
  REQUIRE(plan.has_value());
  std::string faults;
  for (const std::string& fault : faults_of(*plan, job.machine)) faults += fault + "\n";
  CHECK(faults == "");
  return *plan;
}

constexpr const char* kRobot =
    "preset = \"p3\"\nworking_width_m = 4\nbody_width_m = 4\nfront_m = 2.4\nrear_m = 0.6\n"
    "max_steer_deg = 18\nmax_lateral_mps2 = 1.5\nwork_speed_mps = 3.5\n";
constexpr const char* kForwardsOnly = "may_reverse = false\n";
constexpr const char* kTractor = "preset = \"tractor-6m\"\n";

}  // namespace

TEST_CASE("filled corners cover no less and keep every rule of a plan", "[plan][corners]") {
  const auto name =
      GENERATE("f1.geojson", "f2.geojson", "f3.geojson", "f4.geojson", "f5.geojson", "f6.geojson",
               "l_shape.geojson", "u_shape.geojson", "with_pond.geojson", "slanted.geojson");
  const bool may_reverse = GENERATE(true, false);
  const std::string machine = GENERATE(kRobot, kTractor) + std::string{may_reverse ? "" : kForwardsOnly};
  CAPTURE(name, machine);

  const Plan round = planned(name, machine, "corners = \"round\"\n");
  const Plan fill = planned(name, machine, "corners = \"fill\"\n");

  const BlockReport& report = fill.blocks.at(0);
  CHECK(report.covered_m2 >= round.blocks.at(0).covered_m2);
  if (!may_reverse) CHECK(report.reverse_m == 0);
}

TEST_CASE("corners are filled on a headland that is worked first too", "[plan][corners]") {
  const auto name = GENERATE("f6.geojson", "gates_obstacles.geojson");
  const std::string first = "order = \"first\"\ncorners = ";
  const Plan round = planned(name, kRobot, first + "\"round\"\n");
  const Plan fill = planned(name, kRobot, first + "\"fill\"\n");
  CHECK(fill.blocks.at(0).covered_m2 > round.blocks.at(0).covered_m2);
}
