// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "selion/core/angle.hpp"
#include "selion/motion/footprint.hpp"
#include "selion/motion/limits.hpp"
#include "selion/motion/standing.hpp"
#include "selion/motion/timed_turn.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;

Machine husky() {
  for (const MachinePreset& preset : machine_presets())
    if (preset.name == "husky") return preset.machine;
  return {};
}

Stretch pivot_at(const Pose& pose, double angle_rad) {
  return {{pose.at, pose.heading_rad, 0, 0, 0}, Gear::forward, angle_rad};
}

/// Ten metres ahead, a quarter turn on the spot, two metres ahead.
Path round_a_corner(double angle_rad) {
  const Pose corner{{10, 0}, 0};
  const Pose after{{10, 0}, angle_rad};
  return {
      {line({0, 0}, {10, 0})}, pivot_at(corner, angle_rad), {line(after.at, after.at + 2 * unit(angle_rad))}};
}

Footprint footprint() {
  return {.front_m = 1, .rear_m = 0.5, .half_body_m = 0.4, .tool_x_m = 0, .half_tool_m = 0.6};
}

Polygon square(double half_m) {
  return {{{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}}, {}};
}

}  // namespace

TEST_CASE("a pivot takes the time of its wheels from rest to rest", "[motion][pivot]") {
  Machine m = husky();
  m.track_m = 2;  // each side rolls as many metres as there are radians
  m.turn_speed_mps = 1;
  m.max_accel_mps2 = 0.5;
  m.max_brake_mps2 = 1;
  // 1 m and 2 s to gain speed, 0.5 m and 1 s to brake
  CHECK(pivot_s(m, 3) == Approx(3.0 - 1.5 + 3));
  CHECK(pivot_s(m, -3) == pivot_s(m, 3));
  // over 0.6 m the peak is sqrt(0.4) m/s
  CHECK(pivot_s(m, 0.6) == Approx(std::sqrt(2 * 0.6 * (1 / 0.5 + 1 / 1.0))));
  CHECK(pivot_s(m, 1.5) == Approx(3));  // both formulas
  CHECK(pivot_s(m, 0) == 0);
  CHECK(scrub_m(m, -0.5) == 0.5);
}

TEST_CASE("a pivot's heading goes on, its place stays", "[motion][pivot]") {
  const Path path = round_a_corner(kPi / 2);
  const Gaps gap = gaps(path);
  CHECK(gap.position_m < 1e-12);
  CHECK(gap.heading_rad < 1e-12);
  CHECK(length_m(path) == Approx(12));
  CHECK(end_pose(path).heading_rad == Approx(kPi / 2));
  CHECK(end_pose({path.begin(), path.begin() + 2}).heading_rad == Approx(kPi / 2));
  CHECK(gaps({path[0], path[2]}).heading_rad == Approx(kPi / 2));  // without the pivot

  const Path back = backed(path);
  CHECK(gaps(back).heading_rad < 1e-12);
  CHECK(distance_m(start_pose(back).at, end_pose(path).at) < 1e-12);
  CHECK(std::abs(wrapped(start_pose(back).heading_rad - kPi / 2)) < 1e-12);
  CHECK(distance_m(end_pose(back).at, {0, 0}) < 1e-12);
  CHECK(std::abs(wrapped(end_pose(back).heading_rad)) < 1e-12);
  CHECK(back[1].pivot_rad == -path[1].pivot_rad);
}

TEST_CASE("a machine rotates only where all that it sweeps is inside", "[motion][pivot]") {
  const Footprint f = footprint();  // reaches 1.077 m
  const Path round{pivot_at({{0, 0}, 0}, kPi / 2)};
  CHECK(fits(free_space(square(20), f), f, round));
  CHECK(fits(free_space(square(1.08), f), f, round));
  CHECK_FALSE(fits(free_space(square(1.06), f), f, round));
  // Room enough at both ends of the rotation, none between them.
  CHECK(fits(free_space(square(1.06), f), f, Pose{{0, 0}, 0}));
  CHECK(fits(free_space(square(1.06), f), f, Pose{{0, 0}, kPi / 2}));
  // A needle that none of the stands looked at need touch.
  for (const double at : {0.6, 0.7, 0.75, 0.83}) {
    const Point tip = 1.03 * unit(at);
    Polygon pricked = square(3);
    pricked.shell.insert(pricked.shell.begin() + 2, {{3, 2.9}, tip, {2.999, 2.9}});
    CHECK_FALSE(fits(free_space(pricked, f), f, round));
    CHECK(fits(free_space(pricked, f), f, {pivot_at({{0, 0}, 0}, -kPi / 4)}));
  }
  CHECK(swept_by_tool(f, round).empty());
}

TEST_CASE("a drive stands and rotates between its legs", "[motion][pivot]") {
  const Machine m = husky();
  const double angle = GENERATE(kPi / 2, -2.5, 0.02);
  const std::vector<Leg> legs = turn_legs(round_a_corner(angle), m);
  const std::vector<Sample> samples = drive(legs, m);
  CHECK(samples.back().t_s == Approx(duration_s(legs, m, {})).epsilon(1e-12));
  double from_s = -1;
  double to_s = -1;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0) CHECK(samples[i].t_s > samples[i - 1].t_s);
    if (samples[i].leg == 1 && from_s < 0) from_s = samples[i].t_s;
    if (samples[i].leg == 2 && to_s < 0) to_s = samples[i].t_s;
    if (samples[i].leg == 1) CHECK((samples[i].at == Point{10, 0} && samples[i].speed_mps == 0));
    if (samples[i].leg == 2) CHECK(std::abs(wrapped(samples[i].heading_rad - angle)) < 1e-12);
  }
  CHECK(to_s - from_s == Approx(pivot_s(m, angle)));

  const LimitUse use = limit_use(legs, samples, m);
  CHECK(use.speed.share <= 1 + 1e-9);
  CHECK(use.acceleration.share <= 1 + 1e-9);
  std::vector<Leg> hurried = legs;
  hurried[1].wait_s /= 2;
  CHECK(limit_use(hurried, drive(hurried, m), m).acceleration.share == Approx(4));
}

TEST_CASE("the samples of a pivot rotate as its wheels roll", "[motion][pivot]") {
  const Machine m = husky();
  const std::vector<Sample> samples = drive(turn_legs({pivot_at({}, 3)}, m), m);
  REQUIRE(samples.size() == 4);
  const Pivot pivot = pivot_of(m, 3);
  const double rate = 2 * m.turn_speed_mps / m.track_m;
  CHECK(samples[1].heading_rad == Approx(rate * pivot.gain_s / 2));
  CHECK(samples[2].heading_rad - samples[1].heading_rad == Approx(rate * pivot.steady_s));
  CHECK(samples[3].heading_rad == Approx(3));
}

TEST_CASE("pivot turns lead to any pose with two rotations at most", "[motion][pivot]") {
  const Swings swings{limits_at(husky(), 0.4)};
  const auto kind =
      std::find_if(turns().begin(), turns().end(), [](const TurnKind& k) { return k.name == "pivot"; });
  REQUIRE(kind != turns().end());
  const Pose from{{3, 4}, 0.5};
  for (const Pose& goal : {Pose{{0, 0.75}, kPi}, Pose{{2, 0.75}, kPi}, Pose{{-3, -0.75}, kPi},
                           Pose{{5, 2}, 1}, Pose{{0, 0}, 2}, Pose{{-4, 0}, 0}}) {
    const Pose to{placed(from, goal.at), from.heading_rad + goal.heading_rad};
    CAPTURE(goal.at.x_m, goal.at.y_m, goal.heading_rad);
    const auto all = kind->candidates(from, to, swings);
    REQUIRE_FALSE(all.empty());
    for (const Path& path : all) {
      CHECK(gaps(path).heading_rad < 1e-9);
      CHECK(distance_m(end_pose(path).at, to.at) < 1e-9);
      CHECK(std::abs(wrapped(end_pose(path).heading_rad - to.heading_rad)) < 1e-9);
      const auto pivots = std::count_if(path.begin(), path.end(), is_pivot);
      CHECK(pivots <= 2);
    }
  }
  // Between swaths that end apart: on to the end of the longer, then two quarter turns.
  const auto uneven = kind->candidates({}, {{2, 0.75}, kPi}, swings);
  const bool square = std::any_of(uneven.begin(), uneven.end(), [](const Path& path) {
    return path.size() == 4 && path[0].curve.length_m == Approx(2) && path[1].pivot_rad == Approx(kPi / 2) &&
           path[3].pivot_rad == Approx(kPi / 2);
  });
  CHECK(square);
}

TEST_CASE("only who may pivot is shown pivot turns", "[motion][pivot]") {
  const auto pivots = [](const Manoeuvres& may) {
    const Swings swings{limits_at(husky(), 0.4)};
    Connections ways{{}, {{0, 0.75}, kPi}, swings, may};
    int count = 0;
    while (const auto way = ways.next()) count += std::any_of(way->begin(), way->end(), is_pivot) ? 1 : 0;
    return count;
  };
  CHECK(pivots({}) == 0);
  CHECK(pivots({.pivot = true}) > 0);
  Machine m = husky();
  CHECK(manoeuvres_of(m) == Manoeuvres{true, true});
  m.kind = MachineKind::car;
  CHECK_FALSE(manoeuvres_of(m).pivot);
}

TEST_CASE("wheels are steered while standing where curvature jumps", "[motion][pivot]") {
  Machine m;  // 45 degrees, 45 degrees a second, 1.8 m
  const double k = max_curvature_per_m(m);
  const Stretch ahead{{{}, 0, k, 0, 1}};
  const CurveState end = end_of(ahead.curve);
  const auto back = [&](double curvature) {
    return Stretch{{end.at, end.heading_rad + kPi, curvature, 0, 1}, Gear::reverse};
  };
  CHECK(steering_s(m, ahead, back(-k)) == 0);  // the same circle again
  CHECK(steering_s(m, ahead, back(0)) == Approx(1));
  CHECK(steering_s(m, ahead, back(k)) == Approx(2));
  const std::vector<Leg> legs = turn_legs({ahead, back(k)}, m);
  REQUIRE(legs.size() == 3);
  CHECK(legs[1].wait_s == Approx(2));
  CHECK(distance_m(legs[1].stretch.curve.start, end.at) < 1e-12);
  m.kind = MachineKind::differential;
  CHECK(steering_s(m, ahead, back(k)) == 0);
}
