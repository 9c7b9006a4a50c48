// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "files.hpp"
#include "plan_check.hpp"
#include "selion/batch/verified.hpp"
#include "selion/field/read.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

const std::filesystem::path kPublic = shared_dir() / "fields" / "public";

bool skipped() {
  if (std::filesystem::exists(kPublic)) return false;
  WARN("skipped: no shared fields beside this checkout");
  return true;
}

struct Tally {
  int planned = 0;
  int partial = 0;
  int narrow = 0;  // of these: too narrow for the headland that turns need
  int refused = 0;
};

/// Plans one field, tells what came of it and checks it.
void check(const Field& field, const Job& job, Tally& tally) {
  CAPTURE(field.name);
  const auto planned = plan(field, job, Repair::notes_only, no_progress);
  if (!planned) {
    ++tally.refused;
    INFO(planned.error().reason);
    CHECK(planned.error().reason.find(" m ") != std::string::npos);  // a measure: needed, and there is
    return;
  }
  double covered_m2 = 0;
  double area_m2 = 0;
  for (const BlockReport& block : planned->blocks) {
    covered_m2 += block.covered_m2;
    area_m2 += block.area_m2;
  }
  ++(covered_m2 >= 0.9 * area_m2 ? tally.planned : tally.partial);
  const bool fewer = std::any_of(planned->notes.begin(), planned->notes.end(), [](const std::string& note) {
    return note.find("that turns need") != std::string::npos ||
           note.find("worked along its borders") != std::string::npos;
  });
  if (covered_m2 < 0.9 * area_m2 && fewer) ++tally.narrow;
  std::printf("%-40s %10.0f m2 %6.2f %% covered\n", field.name.c_str(), area_m2, 100 * covered_m2 / area_m2);
  std::string faults;
  for (const std::string& fault : faults_of(*planned, job.machine)) faults += fault + "\n";
  CHECK(faults.empty());
  if (!faults.empty()) std::printf("%s", faults.c_str());
}

/// With the 3 m robot.
Tally check_all(const std::filesystem::path& file, HeadlandCorners corners) {
  Job job;
  job.headland.corners = corners;
  std::istringstream nothing;
  Tally tally;
  for (const Field& field : read_fields(file, {}, nothing)) check(field, job, tally);
  std::printf("%s: %d planned, %d partly, %d refused\n", file.filename().c_str(), tally.planned,
              tally.partial, tally.refused);
  return tally;
}

}  // namespace

TEST_CASE("a search may end before it has come to where it sets out", "[plan]") {
  if (skipped()) return;
  const Job job = job_of(settings_of_toml(
      "[machine]\npreset = \"husky\"\nmay_pivot = true\n[headland]\ncorners = \"fill\"\n", "test"));
  std::istringstream nothing;
  Tally tally;
  check(read_fields(kPublic / "curved_ribbon_nl.geojson", {}, nothing).at(0), job, tally);
  CHECK(tally.planned == 1);
}

TEST_CASE("small real fields are planned without a fault, partly or not at all only where narrow", "[plan]") {
  if (skipped()) return;
  const auto name = GENERATE("quad_nz", "parallelogram_at", "l_shape_kh", "l_thin_arm_fi", "c_shape_nz",
                             "t_shape_dk", "sawtooth_fi", "strip_fr", "strip_9m_at", "tiny_quad_vn",
                             "tiny_arrow_pt", "ponds_dk", "y_shape_za");
  const Tally tally = check_all(kPublic / (std::string{name} + ".geojson"), HeadlandCorners::round);
  CHECK(tally.partial == tally.narrow);
}

TEST_CASE("of thirty public fields 28 are planned, the others partly or not for want of width", "[public]") {
  if (skipped()) return;
  const auto corners = GENERATE(HeadlandCorners::round, HeadlandCorners::fill);
  const Tally tally = check_all(kPublic / "_all_public.geojson", corners);
  CHECK(tally.planned >= 28);
  CHECK(tally.partial == tally.narrow);
  CHECK(tally.planned + tally.partial + tally.refused == 30);
}

TEST_CASE("authorities' own files are planned field by field without a fault", "[public]") {
  if (skipped()) return;
  const std::filesystem::path file = kPublic / "original" /
                                     GENERATE("se_2023_shapefile/arslager_skiftePolygon.shp",
                                              "nl_brp2023_100.gpkg", "de_sh_feldbloecke_100_epsg4647.gpkg");
  CHECK(check_all(file, HeadlandCorners::round).planned > 0);
}

TEST_CASE("corners are rounded in a block where filling them leaves pockets out of reach", "[public]") {
  if (skipped()) return;
  std::istringstream nothing;
  ReadOptions crooked;
  crooked.layer = "world_mix";
  crooked.field = "be_vlg2023:79";
  const Field field =
      read_fields(kPublic.parent_path() / "batch" / "fields_batch.gpkg", crooked, nothing).at(0);
  Job job = job_of(settings_of_toml("[machine]\npreset = \"tractor-6m\"\n", "test"));
  const auto round = plan(field, job, Repair::notes_only, no_progress);
  job.headland.corners = HeadlandCorners::fill;
  const auto fill = plan(field, job, Repair::notes_only, no_progress);
  REQUIRE((round && fill));
  CHECK(fill->blocks.at(0).covered_m2 == round->blocks.at(0).covered_m2);
}

TEST_CASE("plans that once had crumbs of a millimetre pass the independent check", "[public]") {
  if (skipped()) return;
  std::istringstream nothing;
  ReadOptions options;
  options.layer = "nl_waterland_brp2020";
  options.field = GENERATE("nl_brp2020_egu:0", "nl_brp2020_egu:338", "nl_brp2020_egu:1838");
  CAPTURE(*options.field);
  const Field field =
      read_fields(kPublic.parent_path() / "batch" / "fields_batch.gpkg", options, nothing).at(0);
  const Job job = job_of(settings_of_toml("[machine]\npreset = \"tractor-6m\"\n", "test"));
  const auto planned = plan(field, job, Repair::notes_only, no_progress);
  REQUIRE(planned.has_value());
  CHECK(verification_of(planned->file).faults == std::vector<std::string>{});
}
