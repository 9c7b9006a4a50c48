// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "motion_drives.hpp"
#include "selion/motion/limits.hpp"
#include "selion/motion/speed.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

Machine machine() {
  Machine m;
  m.max_speed_mps = 5;
  m.max_accel_mps2 = 0.5;
  m.max_brake_mps2 = 0.8;
  return m;
}

std::vector<Leg> legs_of(const Path& path, double cap_mps) {
  std::vector<Leg> legs;
  for (const Stretch& stretch : path) legs.push_back({stretch, cap_mps});
  return legs;
}

Leg straight(double from_m, double to_m, double cap_mps) { return {{line({from_m, 0}, {to_m, 0})}, cap_mps}; }

/// Out, a U-turn, back; then away backwards and forwards again, with a wait and tiny legs in between.
std::vector<Leg> field_drive(unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> any{0.2, 3};
  std::vector<Leg> legs;
  Pose at{{0, 0}, 0.3};
  for (int i = 0; i < 6; ++i) {
    const Pose end{placed(at, {40, 0}), at.heading_rad};
    legs.push_back({{line(at.at, end.at)}, any(random), true});
    legs.push_back({{line(end.at, placed(end, {2e-7, 0}))}, 1, false});
    const Pose start{placed(end, {2e-7, 0}), end.heading_rad};
    const Pose next{placed(start, {0, 3.0 * (i % 2 == 0 ? 1 : -1)}), start.heading_rad + std::numbers::pi};
    for (const Leg& leg : legs_of(connections(start, next, limits_at(machine(), 1)).front(), any(random)))
      legs.push_back(leg);
    Leg wait{{{next.at, next.heading_rad, 0, 0, 0}}, 1};
    wait.wait_s = 4;
    legs.push_back(wait);
    const Curve back{next.at, next.heading_rad + std::numbers::pi, 0, 0, 1.5};
    legs.push_back({{back, Gear::reverse}, any(random)});
    legs.push_back({{reversed(back), Gear::forward}, any(random)});
    at = next;
  }
  return legs;
}

double way_m(const std::vector<Leg>& legs, const Sample& from, const Sample& to) {
  if (from.leg == to.leg) return to.s_m - from.s_m;
  double way = legs[from.leg].stretch.curve.length_m - from.s_m + to.s_m;
  for (std::size_t i = from.leg + 1; i < to.leg; ++i) way += legs[i].stretch.curve.length_m;
  return way;
}

}  // namespace

TEST_CASE("a drive keeps caps and accelerations, and its speed integrates to the way", "[motion][speed]") {
  const Machine m = machine();
  for (unsigned seed = 0; seed < 5; ++seed) {
    const auto legs = field_drive(seed);
    const auto samples = drive(legs, m);
    REQUIRE(samples.size() > legs.size() / 2);
    check_within(limit_use(legs, samples, m));
    CHECK(samples.front().speed_mps == 0);
    CHECK(samples.back().speed_mps == 0);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const Sample& a = samples[i - 1];
      const Sample& b = samples[i];
      CAPTURE(i, a.leg, b.leg, a.s_m, b.s_m, a.t_s, b.t_s, a.speed_mps, b.speed_mps);
      const double dt = b.t_s - a.t_s;
      REQUIRE(dt > 0);
      const double v0 = std::abs(a.speed_mps);
      const double v1 = std::abs(b.speed_mps);
      REQUIRE((legs[a.leg].wait_s == 0 || v0 + v1 == 0));
      REQUIRE((v1 - v0) / dt <= m.max_accel_mps2 * (1 + 1e-6));
      REQUIRE((v0 - v1) / dt <= m.max_brake_mps2 * (1 + 1e-6));
      REQUIRE(std::abs((v0 + v1) / 2 * dt - way_m(legs, a, b)) < 1e-6);
      REQUIRE(distance_m(a.at, b.at) <= 100 + 1e-9);
      const Curve& curve = legs[a.leg].stretch.curve;
      if (curve.curvature_per_m != 0 || curve.sharpness_per_m2 != 0)
        REQUIRE(distance_m(a.at, b.at) <= 0.25 + 1e-9);
      const bool reverse = legs[a.leg].stretch.gear == Gear::reverse;
      REQUIRE((reverse ? a.speed_mps <= 0 : a.speed_mps >= 0));
      REQUIRE(a.tool_down == legs[a.leg].tool_down);
    }
  }
}

TEST_CASE("a sample stands at every start of a leg that takes time", "[motion][speed]") {
  const auto legs = field_drive(1);
  const auto samples = drive(legs, machine());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].stretch.curve.length_m < 1e-6 && legs[i].wait_s == 0) continue;
    CHECK(std::count_if(samples.begin(), samples.end(),
                        [i](const Sample& s) { return s.leg == i && s.s_m == 0; }) == 1);
  }
}

TEST_CASE("100 m on a straight are a trapezoid", "[motion][speed]") {
  // 2 m/s: 4 m and 4 s to accelerate, 2.5 m and 2.5 s to brake, 93.5 m and 46.75 s between.
  const auto samples = drive(std::vector{straight(0, 100, 2)}, machine());
  REQUIRE(samples.size() == 4);
  CHECK(samples[1].s_m == Approx(4));
  CHECK(samples[1].t_s == Approx(4));
  CHECK(samples[1].speed_mps == Approx(2));
  CHECK(samples[2].s_m == Approx(97.5));
  CHECK(samples[2].t_s == Approx(50.75));
  CHECK(samples[3].t_s == Approx(53.25));
  CHECK(samples[3].at == Point{100, 0});
}

TEST_CASE("where the cap is out of reach the profile is a triangle", "[motion][speed]") {
  // v^2 / (2 x .5) + v^2 / (2 x .8) = 1.3 m: v = .8944 m/s after .8 m; 1.789 s and 1.118 s.
  const auto samples = drive(std::vector{straight(0, 1.3, 3)}, machine());
  REQUIRE(samples.size() == 3);
  CHECK(samples[1].s_m == Approx(0.8));
  CHECK(samples[1].speed_mps == Approx(std::sqrt(0.8)));
  CHECK(samples[2].t_s == Approx(2 * 0.8 / std::sqrt(0.8) + 2 * 0.5 / std::sqrt(0.8)));
}

TEST_CASE("a lower cap ahead is braked for, a higher one waited for", "[motion][speed]") {
  const auto samples =
      drive(std::vector{straight(0, 50, 3), straight(50, 60, 1), straight(60, 120, 3)}, machine());
  for (const Sample& sample : samples) {
    if (sample.leg == 1) CHECK(sample.speed_mps == Approx(1));
  }
  const auto corner =
      std::find_if(samples.begin(), samples.end(), [](const Sample& s) { return s.s_m == Approx(45); });
  REQUIRE(corner != samples.end());  // (9 - 1) / (2 x .8) = 5 m before the joint
  CHECK(corner->speed_mps == Approx(3));
}

TEST_CASE("a change of tool is a sample, not a stop", "[motion][speed]") {
  std::vector<Leg> legs{straight(0, 50, 2), straight(50, 100, 2)};
  const double undisturbed_s = drive(std::vector{straight(0, 100, 2)}, machine()).back().t_s;
  legs[1].tool_down = true;
  const auto samples = drive(legs, machine());
  CHECK(samples.back().t_s == Approx(undisturbed_s));
  const auto change =
      std::find_if(samples.begin(), samples.end(), [](const Sample& s) { return s.tool_down; });
  REQUIRE(change != samples.end());
  CHECK(change->at == Point{50, 0});
  CHECK(change->speed_mps == 2);
}

TEST_CASE("a wait repeats the position at rest", "[motion][speed]") {
  Leg wait{{{{50, 0}, 0, 0, 0, 0}}, 1};
  wait.wait_s = 7;
  const auto samples = drive(std::vector{straight(0, 50, 2), wait, straight(50, 100, 2)}, machine());
  const auto stop = std::find_if(samples.begin(), samples.end(), [](const Sample& s) { return s.leg == 1; });
  REQUIRE(stop != samples.end());
  CHECK(stop->speed_mps == 0);
  CHECK((stop + 1)->leg == 2);
  CHECK((stop + 1)->at == stop->at);
  CHECK((stop + 1)->t_s == stop->t_s + 7);
}

TEST_CASE("a path driven back in the other order takes as long where braking is as strong",
          "[motion][speed]") {
  Machine m = machine();
  m.max_brake_mps2 = m.max_accel_mps2;
  const Path path = connections({{0, 0}, 0}, {{3, 4}, 2.5}, limits_at(m, 1)).front();
  auto legs = legs_of(path, 1.7);
  for (std::size_t i = 0; i < legs.size(); i += 2) legs[i].speed_cap_mps = 0.9;
  auto back = legs_of(backed(path), 1.7);
  std::transform(back.begin(), back.end(), legs.rbegin(), back.begin(), [](Leg leg, const Leg& other) {
    leg.speed_cap_mps = other.speed_cap_mps;
    return leg;
  });
  const auto there = drive(legs, m);
  const auto here = drive(back, m);
  CHECK(here.back().t_s == Approx(there.back().t_s).epsilon(1e-9));
  CHECK(std::any_of(here.begin(), here.end(), [](const Sample& s) { return s.speed_mps < 0; }));
  CHECK(here.back().heading_rad == Approx(there.front().heading_rad).margin(1e-9));
}

TEST_CASE("legs of any smallness keep the times increasing", "[motion][speed]") {
  std::vector<Leg> legs;
  double at = 0;
  for (int i = 0; i < 400; ++i) {
    const double next = at + std::pow(10, -9 + 10 * (i % 37) / 37.0);
    legs.push_back(straight(at, next, 0.5 + i % 3));
    at = next;
  }
  const auto samples = drive(legs, machine());
  REQUIRE(samples.size() > 100);
  for (std::size_t i = 1; i < samples.size(); ++i) REQUIRE(samples[i].t_s > samples[i - 1].t_s);
  CHECK(std::isfinite(samples.back().t_s));
  CHECK(samples.back().at.x_m == Approx(at));
}

TEST_CASE("nothing to drive is no drive, and standing still is one moment", "[motion][speed]") {
  CHECK(drive({}, machine()).empty());
  CHECK(drive(std::vector{Leg{{{{1, 2}, 0, 0, 0, 0}}, 1}}, machine()).size() == 1);
}
