// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "layout/parts.hpp"
#include "layout/ring_legs.hpp"
#include "layout/swept_ground.hpp"
#include "selion/layout/layout.hpp"

using namespace selion;

namespace {

constexpr double kMargin_m = 0.05;

/// As wide as its tool, 2.4 m before the axle and 0.6 m behind it.
Machine robot_4m(bool may_reverse) {
  const auto presets = machine_presets();
  Machine machine = std::find_if(presets.begin(), presets.end(), [](const MachinePreset& preset) {
                      return preset.name == "p3";
                    })->machine;
  machine.working_width_m = machine.body_width_m = 4;
  machine.front_m = 2.4;
  machine.rear_m = 0.6;
  machine.max_steer_deg = 18;
  machine.may_reverse = may_reverse;
  return machine;
}

Block block_of(const Ring& shell) {
  Block block;
  block.area = block.free = {shell, {}};
  return block;
}

const Ring kSquare{{0, 0}, {100, 0}, {100, 100}, {0, 100}};

Layout laid_out(const Block& block, const Machine& machine, HeadlandCorners corners) {
  LayoutOptions options;
  options.edge_margin_m = kMargin_m;
  options.corners = corners;
  auto layout = layouts().front().lay_out(block, machine, options);
  REQUIRE(layout.has_value());
  return *layout;
}

double area_sum_m2(const Polygons& areas) {
  double sum = 0;
  for (const Polygon& area : areas) sum += area_m2(area);
  return sum;
}

/// Unworked ground in the square whose sides are `side_m` along the border from a corner of kSquare.
double unworked_m2(const Block& block, const Machine& machine, const Layout& layout, Point corner,
                   double side_m) {
  const Polygons left = unworked(ground_of(block, machine, kMargin_m), layout, layout.pockets);
  const double x = corner.x_m > 0 ? corner.x_m - side_m : 0;
  const double y = corner.y_m > 0 ? corner.y_m - side_m : 0;
  const Ring box{{x, y}, {x + side_m, y}, {x + side_m, y + side_m}, {x, y + side_m}};
  return area_sum_m2(intersect(left, {Polygon{box, {}}}));
}

std::size_t parts_of(const Layout& layout) {
  std::size_t count = 0;
  for (const HeadlandPass& pass : layout.headland_passes) count += pass.parts.size();
  return count;
}

}  // namespace

TEST_CASE("a square ring has four sides and four left turns in its corners", "[layout]") {
  const Layout layout = laid_out(block_of(kSquare), robot_4m(true), HeadlandCorners::round);
  for (const HeadlandPass& pass : layout.headland_passes) {
    const std::vector<RingLeg> legs = legs_of(pass.path, 2);
    REQUIRE(legs.size() == 4);
    for (std::size_t i = 0; i < legs.size(); ++i) {
      const auto turn = left_turn(legs[i].bend);
      REQUIRE(turn.has_value());
      CHECK(turn->turn_rad == Approx(std::numbers::pi / 2));
      const Point corner = on_from(turn->in, turn->before_m).at;
      CHECK(distance_m(corner, on_from(turn->out, -turn->after_m).at) < 1e-9);
      CHECK(distance_m(turn->out.at, legs[(i + 1) % 4].side.curve.start) < 1e-6);
    }
    CHECK_FALSE(left_turn(turned_round(legs[0].bend)).has_value());  // to the right
  }
}

TEST_CASE("rounding leaves corners of a square unworked, filling what body and tool cannot reach",
          "[layout]") {
  const Block block = block_of(kSquare);
  const Machine machine = robot_4m(true);
  const Layout round = laid_out(block, machine, HeadlandCorners::round);
  const Layout fill = laid_out(block, machine, HeadlandCorners::fill);
  const double lane_m = machine.working_width_m + kMargin_m;
  // the tool begins `rear` from one border, the pass before it ends `front` from the other
  const double reach_m2 = machine.rear_m * machine.front_m;
  for (const Point corner : kSquare) {
    CAPTURE(corner.x_m, corner.y_m);
    CHECK(unworked_m2(block, machine, round, corner, lane_m) > 5);
    CHECK(unworked_m2(block, machine, fill, corner, lane_m) < reach_m2);
    CHECK(unworked_m2(block, machine, fill, corner, 20) < 2 * reach_m2);
  }
}

TEST_CASE("the parts of a ring with filled corners lead on to each other", "[layout]") {
  const bool may_reverse = GENERATE(true, false);
  Machine machine = robot_4m(may_reverse);
  if (!may_reverse) machine.min_work_radius_m = 8;  // with the tool up it turns more tightly
  const Block block = block_of(kSquare);
  const Ground ground = ground_of(block, machine, kMargin_m);
  const Layout layout = laid_out(block, machine, HeadlandCorners::fill);
  REQUIRE(parts_of(layout) >= 4);
  for (const HeadlandPass& pass : layout.headland_passes) {
    for (std::size_t i = 0; i < pass.parts.size(); ++i) {
      const HeadlandPart& part = pass.parts[i];
      Path joined = part.path;
      append(joined, part.way_on);
      append(joined, pass.parts[(i + 1) % pass.parts.size()].path);
      const Gaps gap = gaps(joined);
      CHECK(gap.position_m < 1e-6);
      CHECK(gap.heading_rad < 1e-9);
      CHECK(gap.curvature_per_m < 1e-9);
      CHECK(fits(ground.space, ground.footprint, joined));
      for (const Stretch& stretch : part.path) CHECK(stretch.gear == Gear::forward);
      for (const Stretch& stretch : part.way_on) CHECK((may_reverse || stretch.gear == Gear::forward));
    }
  }
}

TEST_CASE("filling leaves no more unworked than rounding, whatever the machine", "[layout]") {
  const Block block = block_of({{0, 0}, {120, 0}, {150, 60}, {90, 40}, {20, 110}});
  Machine machine = robot_4m(GENERATE(true, false));
  if (GENERATE(true, false)) machine.min_work_radius_m = 7;
  machine.front_m = GENERATE(2.4, 5.0);
  machine.tool_x_m = GENERATE(0.0, -2.5);
  machine.rear_m = std::max(machine.rear_m, -machine.tool_x_m);
  CAPTURE(machine.may_reverse, machine.min_work_radius_m.value_or(0), machine.front_m, machine.tool_x_m);
  const auto left_m2 = [&](HeadlandCorners corners) {
    Layout layout = laid_out(block, machine, corners);
    return area_sum_m2(unworked(ground_of(block, machine, kMargin_m), layout, {}));
  };
  CHECK(left_m2(HeadlandCorners::fill) <= left_m2(HeadlandCorners::round));
}

TEST_CASE("a ring that bends smoothly is not cut", "[layout]") {
  Ring circle;
  for (int i = 0; i < 180; ++i) circle.push_back(60 * unit(i * std::numbers::pi / 90));
  CHECK(parts_of(laid_out(block_of(circle), robot_4m(true), HeadlandCorners::fill)) == 0);
}

TEST_CASE("blunt corners are rounded, square and sharp ones filled", "[layout]") {
  const auto parts_at = [](int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i) ring.push_back(80 * unit(2 * std::numbers::pi * i / corners));
    return parts_of(laid_out(block_of(ring), robot_4m(true), HeadlandCorners::fill));
  };
  CHECK(parts_at(8) == 0);
  CHECK(parts_at(4) >= 4);
  CHECK(parts_at(3) >= 3);
}
