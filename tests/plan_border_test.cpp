// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "field_samples.hpp"
#include "plan_check.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

/// A round bay-and-cape field of 5 ha as somebody drives its border with a receiver: a corner each 0.2 m,
/// every one off by up to `noise_m`.
Field driven_border(double noise_m) {
  constexpr int kCorners = 4000;
  std::mt19937 random{5};
  Ring ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    const double off = noise_m * (2 * static_cast<double>(random()) / 0x1p32 - 1);
    ring.push_back((126 * (1 + 0.1 * std::cos(2 * angle + 0.3) + 0.05 * std::cos(3 * angle + 1)) + off) *
                   unit(angle));
  }
  return field_of_metres({{ring, {}}});
}

Job forwards_4m() {
  return job_of(settings_of_toml(
      "[machine]\npreset = \"p3\"\nworking_width_m = 4\nbody_width_m = 4\nfront_m = 2.4\nrear_m = 0.6\n"
      "max_steer_deg = 18\nmay_reverse = false\n",
      "test"));
}

Ring circle(double radius_m, int count = 128) {
  Ring corners;
  for (int i = 0; i < count; ++i) corners.push_back(radius_m * unit(2 * std::numbers::pi * i / count));
  return corners;
}

/// 200 m by 120 m with corners of this radius.
Ring rounded(double radius_m) {
  constexpr int kSteps = 24;  // a corner
  const std::array<Point, 4> centres{Point{200 - radius_m, 120 - radius_m},
                                     {radius_m, 120 - radius_m},
                                     {radius_m, radius_m},
                                     {200 - radius_m, radius_m}};
  Ring corners;
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k <= kSteps; ++k)
      corners.push_back(centres[static_cast<std::size_t>(i)] +
                        radius_m * unit(std::numbers::pi / 2 * (i + static_cast<double>(k) / kSteps)));
  return corners;
}

}  // namespace

TEST_CASE("a border driven with a receiver's noise is worked all round, forwards only", "[plan]") {
  const auto [noise_m, covered_percent] =
      GENERATE(table<double, double>({{0.0, 99.5}, {0.01, 99.3}, {0.03, 99.0}}));
  CAPTURE(noise_m);
  const Job job = forwards_4m();

  const auto planned = plan(driven_border(noise_m), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(100 * block.covered_m2 / block.area_m2 >= covered_percent);
  CHECK(faults_of(*planned, job.machine).empty());
}

TEST_CASE("a border that bends gently is worked all round though the front swings out over it", "[plan]") {
  const auto [border, covered_percent] = GENERATE(table<Ring, double>({{circle(80, 360), 99.5},
                                                                       {circle(50, 360), 98.5},
                                                                       {circle(100, 1000), 99.5},
                                                                       {rounded(15), 99.0},
                                                                       {rounded(25), 99.4},
                                                                       {rounded(40), 99.4}}));
  CAPTURE(border.size(), covered_percent);
  const Job job = forwards_4m();

  const auto planned = plan(field_of_metres({{border, {}}}), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(100 * block.covered_m2 / block.area_m2 >= covered_percent);
  CHECK(faults_of(*planned, job.machine).empty());
}

TEST_CASE("a block covered badly with the headland that turns need gets a narrower one", "[plan]") {
  const Ring wedge{{0, 0}, {317.5, 44.6}, {311.9, 84.3}, {-1.1, 7.9}};
  const Job job = forwards_4m();

  const auto planned = plan(field_of_metres({{wedge, {}}}), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.8 * block.area_m2);
  CHECK(faults_of(*planned, job.machine).empty());
}

TEST_CASE("a closed band is worked by going round in it, not by swaths across its bends", "[plan]") {
  const double width_m = GENERATE(14.0, 16.0, 20.0, 24.0);
  const auto* const may_reverse = GENERATE("false", "true");
  CAPTURE(width_m, may_reverse);
  const Field field = field_of_metres({{circle(100), {circle(100 - width_m)}}});
  const Job job = job_of(settings_of_toml(
      "[machine]\npreset = \"tractor-6m\"\nmay_reverse = " + std::string{may_reverse} + "\n", "test"));

  const auto planned = plan(field, job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.94 * block.area_m2);
  CHECK(block.work_m + block.turn_m + block.transfer_m < 2600);
  CHECK(faults_of(*planned, job.machine).empty());
}

TEST_CASE("a closed band in which there is room for swaths is worked by going round in it too", "[plan]") {
  const double width_m = GENERATE(13.0, 14.0, 17.0, 20.0, 24.0);
  CAPTURE(width_m);
  const Field field = field_of_metres({{circle(65), {circle(65 - width_m)}}});
  const Job job = job_of(settings_of_toml("[machine]\nmay_reverse = false\n", "test"));

  const auto planned = plan(field, job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.92 * block.area_m2);
  CHECK(block.work_m + block.turn_m + block.transfer_m < 1.15 * block.area_m2 / job.machine.working_width_m);
  CHECK(faults_of(*planned, job.machine).empty());
}

TEST_CASE("a bent strip a few passes wide is worked along its borders, not by swaths across its bend",
          "[plan]") {
  const auto [preset, width_m] = GENERATE(
      table<const char*, double>({{"robot-3m", 15}, {"robot-3m", 18}, {"robot-3m", 22}, {"tractor-6m", 18}}));
  CAPTURE(preset, width_m);
  constexpr int kSteps = 64;
  Ring strip;  // not of quite the same width all along, as none is
  const auto at = [](int step) { return unit(0.9 * std::numbers::pi * step / kSteps); };
  for (int i = 0; i <= kSteps; ++i) strip.push_back(150 * at(i));
  for (int i = kSteps; i >= 0; --i) strip.push_back(Point{0.05, 0} + (150 - width_m) * at(i));
  const Job job = job_of(settings_of_toml(std::string{"[machine]\npreset = \""} + preset + "\"\n", "test"));

  const auto planned = plan(field_of_metres({{strip, {}}}), job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.95 * block.area_m2);
  CHECK(block.work_m + block.turn_m + block.transfer_m < 1.5 * block.area_m2 / job.machine.working_width_m);
  CHECK(faults_of(*planned, job.machine).empty());
}

TEST_CASE("a ditch or hedge that reaches into a field is driven round, however thin it is", "[plan]") {
  const auto [preset, thin_m] = GENERATE(table<const char*, double>({{"robot-3m", 0.1},
                                                                     {"robot-3m", 0.5},
                                                                     {"robot-3m", 1},
                                                                     {"robot-3m", 1.5},
                                                                     {"tractor-6m", 1},
                                                                     {"tractor-6m", 3}}));
  const bool may_reverse = GENERATE(true, false);
  CAPTURE(preset, thin_m, may_reverse);
  const double left_m = 100 - thin_m / 2;
  const double right_m = 100 + thin_m / 2;
  const Field field = field_of_metres(
      {{{{0, 0}, {240, 0}, {240, 150}, {right_m, 150}, {right_m, 60}, {left_m, 60}, {left_m, 150}, {0, 150}},
        {}}});
  const Job job = job_of(settings_of_toml(std::string{"[machine]\npreset = \""} + preset +
                                              "\"\nmay_reverse = " + (may_reverse ? "true\n" : "false\n"),
                                          "test"));

  const auto planned = plan(field, job, Repair::notes_only, no_progress);

  REQUIRE(planned.has_value());
  CHECK(faults_of(*planned, job.machine).empty());
  const BlockReport& block = planned->blocks.at(0);
  CHECK(block.covered_m2 >= 0.98 * block.area_m2);
  double round_m = 0;
  for (const TrajectoryRecord& trajectory : planned->file.trajectories)
    for (const PieceRecord& piece : trajectory.pieces)
      if (piece.ref == "H1") round_m += piece.length_m;
  CHECK(round_m > 850);  // of 960, all round in one
}
