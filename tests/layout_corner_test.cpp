// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>

#include "layout/corner_shape.hpp"
#include "layout/open_runs.hpp"
#include "layout/parts.hpp"
#include "selion/core/machine.hpp"
#include "selion/layout/layout.hpp"

using namespace selion;

namespace {

constexpr CurveLimits kLimits{0.271, 0.327};
/// As wide as its tool, 2.4 m before the axle.
constexpr Footprint kBody{2.4, 0.6, 2, 0, 2};

/// How far body and tool get beyond the right edge of the lane before the turn and of the lane after it.
double swing_out_m(const Path& path, const Footprint& f) {
  const Pose last = end_pose(path);
  const Point right = -1 * left_of(unit(last.heading_rad));
  double out = 0;
  for (const Pose& pose : poses(path, 0.02))
    for (const Point corner : {Point{f.front_m, -f.half_body_m}, Point{f.front_m, f.half_body_m},
                               Point{-f.rear_m, -f.half_body_m}, Point{f.tool_x_m, -f.half_tool_m}}) {
      const Point p = placed(pose, corner);
      out = std::max({out, -p.y_m - 2, dot(p - last.at, right) - 2});
    }
  return out;
}

}  // namespace

TEST_CASE("a corner turns by what it should, ends straight and keeps the limits", "[layout]") {
  const double turn = GENERATE(0.05, 0.3, 1.0, 1.57, 2.4, -0.3, -1.57);
  const double ease_in = GENERATE(0.0, 1.5);
  const double ease_out = GENERATE(0.0, 0.1, 2.4);
  CAPTURE(turn, ease_in, ease_out);
  const Path path = corner_path({{3, -2}, 0.7}, turn, {kLimits, ease_in, ease_out});
  CHECK(end_pose(path).heading_rad == Approx(0.7 + turn).margin(1e-9));
  CHECK(std::abs(end_of(path.back().curve).curvature_per_m) < 1e-9);
  const Gaps gap = gaps(path);
  CHECK(gap.position_m < 1e-9);
  CHECK(gap.curvature_per_m < 1e-9);
  for (const Stretch& stretch : path) {
    CHECK(std::abs(stretch.curve.curvature_per_m) <= kLimits.curvature_per_m * (1 + 1e-9));
    CHECK(std::abs(stretch.curve.sharpness_per_m2) <= kLimits.sharpness_per_m2 * (1 + 1e-9));
  }
}

TEST_CASE("a corner begins and ends on its two lines", "[layout]") {
  const double turn = GENERATE(0.2, 1.2, 2.4);
  const CornerShape shape{kLimits, 0, GENERATE(0.0, 2.4)};
  const CornerReach reach = reach_of(turn, shape);
  const Path path = corner_path({{-reach.before_m, 0}, 0}, turn, shape);  // the lines meet at the origin
  const Point end = end_pose(path).at;
  CHECK(distance_m(end, reach.after_m * unit(turn)) < 1e-9);
  double nearest = 1e9;
  for (const Pose& pose : poses(path, 0.01)) nearest = std::min(nearest, length_m(pose.at));
  CHECK(reach.cut_m == Approx(nearest).margin(0.02));
}

TEST_CASE("a long body does not swing out of its lane by more than it may", "[layout]") {
  const double turn = GENERATE(0.1, 0.5, 1.0, 1.57, 2.4);
  const double room = GENERATE(0.01, 0.07, 0.3, 2.0);
  CAPTURE(turn, room);
  const CornerShape shape = shape_within(turn, kLimits, kBody, room);
  CHECK(swing_out_m(corner_path({}, turn, shape), kBody) <= room + 0.005);
}

TEST_CASE("a corner is eased no further than its body needs", "[layout]") {
  const Footprint compact{0.5, 0.5, 1, 0, 2};
  CHECK(shape_within(1.57, kLimits, compact, 0.07).ease_out_m == 0);
  const double little = shape_within(1.57, kLimits, kBody, 0.3).ease_out_m;
  const double much = shape_within(1.57, kLimits, kBody, 0.02).ease_out_m;
  CHECK(little < much);
  CHECK(shape_within(1.57, kLimits, kBody, 2).ease_out_m == 0);
  CHECK(shape_within(-1.57, kLimits, kBody, 0.02).ease_out_m == 0);
}

TEST_CASE("a tip too sharp to be driven round leaves the passes beside its long edge parallel to it",
          "[layout]") {
  Machine machine;
  for (const MachinePreset& known : machine_presets())
    if (known.name == "robot-3m") machine = known.machine;
  const double sense = GENERATE(1.0, -1.0);  // the long edge before the tip, or after it
  const double tip_x_m = 300;
  Ring ring{{0, 0}, {tip_x_m, 0}, {240, 12}, {240, 80}, {0, 80}};
  if (sense < 0) {
    for (Point& p : ring) p.x_m = -p.x_m;
    std::reverse(ring.begin(), ring.end());
  }
  Block block;
  block.area = block.free = Polygon{ring, {}};
  const Ground ground = ground_of(block, machine, 0.1);
  auto passes = lay_headland(ground, 2);
  std::erase_if(passes, [](const HeadlandPass& pass) { return !pass.closed; });  // into the tip
  REQUIRE(passes.size() == 2);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double beside_m = 0.1 + ring_inset_m(ground, passes[i].ring);
    double longest_m = 0;
    for (const Stretch& stretch : passes[i].path) {
      const Point end = end_of(stretch.curve).at;
      if (is_straight(stretch.curve) && stretch.curve.start.y_m < 20 && end.y_m < 20 &&
          stretch.curve.length_m > 100) {
        CHECK(stretch.curve.start.y_m == Approx(beside_m).margin(0.02));
        CHECK(end.y_m == Approx(beside_m).margin(0.02));
        longest_m = std::max(longest_m, stretch.curve.length_m);
      }
    }
    CHECK(longest_m > 200);
  }
}

TEST_CASE("a corner at which a border leads straight on parts no headland pass", "[layout]") {
  Machine machine;
  for (const MachinePreset& known : machine_presets())
    if (known.name == "robot-3m") machine = known.machine;
  const Ring plain{{10, 10}, {90, 10}, {90, 50}, {10, 50}};
  const Ring with_corner{{10, 10}, {40, 10}, {90, 10}, {90, 50}, {10, 50}};
  Block block;
  block.area = block.free = Polygon{{{0, 0}, {100, 0}, {100, 60}, {0, 60}}, {}};
  const Ground ground = ground_of(block, machine, 0.1);
  const auto lengths_m = [&](const Ring& ring) {
    std::vector<double> lengths;
    for (const HeadlandRun& run : runs_on_edges(ground, ring, 1)) lengths.push_back(length_m(run.path));
    std::sort(lengths.begin(), lengths.end());
    return lengths;
  };
  const std::vector<double> sides = lengths_m(plain);
  CHECK(sides.size() == 4);
  CHECK_THAT(lengths_m(with_corner), Catch::Matchers::Approx(sides).margin(1e-6));
}
