// SPDX-License-Identifier: GPL-3.0-or-later
#include "planfile_samples.hpp"
#include "test.hpp"

#include <cmath>

using namespace selion;

namespace {

LonLatLine square(double lon, double lat, double side) {
  const auto as_written = [](double deg) { return std::round(deg * 1e9) / 1e9; };
  const double east = as_written(lon + side);
  const double north = as_written(lat + side);
  return {{lon, lat}, {east, lat}, {east, north}, {lon, north}};
}

LonLatLine backwards(const LonLatLine& ring) { return {ring[0], ring[3], ring[2], ring[1]}; }

TrajectoryRecord sample_trajectory(int block) {
  TrajectoryRecord t{.block = block, .robot = 1, .working_width_m = 3, .length_m = 42.5, .duration_s = 71.25};
  t.pieces = {
      {.kind = "swath",
       .ref = "1",
       .x_m = -12.5,
       .y_m = 3.123456789,
       .heading_rad = 0.785398163397,
       .length_m = 30,
       .tool = 1},
      {.kind = "turn",
       .x_m = 8,
       .curvature_per_m = 0.25,
       .sharpness_per_m2 = -0.327,
       .length_m = 4.5,
       .offset_m = 0.5},
      {.kind = "turn", .x_m = 9, .y_m = 1, .heading_rad = -3.141592653589, .length_m = 4, .gear = -1},
      {.kind = "pivot", .x_m = 9, .y_m = 1, .angle_rad = 1.57079633, .duration_s = 6.5},
      {.kind = "wait", .x_m = 9, .y_m = 1, .duration_s = 12.25, .for_robot = 2, .until_station_m = 100.5},
      {.kind = "headland_pass", .ref = "H1", .x_m = 9, .y_m = 1, .length_m = 4, .tool = 1},
  };
  t.line = {{3.4094, 46.3367}, {3.4095, 46.3368}, {3.4095, 46.3368}};
  t.t_s = {0, 20.5, 71.25};
  t.heading_rad = {0.78539816, 0.78539816, -1.57079633};
  t.curvature_per_m = {0, 0.25, -0.12345678};
  t.speed_mps = {0, 1.5, -0.5};
  t.tool = {1, 0, 0};
  return t;
}

}  // namespace

PlanFile sample_plan() {
  PlanFile plan;
  plan.version = "0.1.0";
  plan.id = "0123456789abcdef";
  plan.proj = "+proj=tmerc +lat_0=46.3367 +lon_0=3.4094 +k=1 +ellps=WGS84";
  plan.origin = {3.4094, 46.3367};
  plan.job_json =
      R"({"operation":"seeding","machine":{"working_width_m":3.0,"name":"a \"b\" }{"},"ab":[],"z":1e-3,"a":null})";
  plan.summary = {{"covered_m2", 50912.25}, {"area_m2", 51000}, {"worked_twice_m2", 0}};
  plan.warnings = {"the boundary's accuracy is unknown", "tab\tand \"quotes\""};
  const LonLatArea ring{square(3.409, 46.336, 0.004),
                        {backwards(square(3.41, 46.337, 0.001)), backwards(square(3.412, 46.337, 0.0005))}};
  plan.fields = {
      {{ring, {square(3.42, 46.336, 0.001), {}}}, "Près du bois", 51000.5, {"1 spike removed", "closed"}}};
  plan.obstacles = {{1, {square(3.41, 46.337, 0.001), {}}, "pond", "water"},
                    {2, {square(3.4203, 46.3362, 0.0001), {}}, "", "obstacle"}};
  plan.gates = {{1, {3.409, 46.3365}, "north", 4.5}, {2, {3.42, 46.3365}, "", std::nullopt}};
  plan.cells = {{1, "1", {ring}, 12.5}, {2, "2", {{square(3.4201, 46.3361, 0.0008), {}}}, 0}};
  plan.ab_lines = {{1, {3.4091, 46.3361}, {3.4092, 46.3399}, 1.25}};
  plan.headlands = {
      {1, {{square(3.409, 46.336, 0.004), {backwards(square(3.4092, 46.3362, 0.0036))}}}, 6.5, 2}};
  plan.headland_passes = {{1, "H1", 1, square(3.4091, 46.3361, 0.0038), 3}};
  plan.swaths = {{1, "12a", "1", {{3.41, 46.3363}, {3.41, 46.3397}}, 3, 378.1234, 7},
                 {2, "P3", "2", {{3.4202, 46.3363}, {3.4203, 46.3364}}, 3, 12, 0}};
  plan.trajectories = {sample_trajectory(1), sample_trajectory(2)};
  return plan;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  CAPTURE(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}
