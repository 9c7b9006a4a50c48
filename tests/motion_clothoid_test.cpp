// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "selion/core/angle.hpp"
#include "selion/motion/clothoid.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;

/// By the distance of the poses.
double miss(const Curve& curve, const Pose& to) {
  return distance_m(end_of(curve).at, to.at) / distance_m(curve.start, to.at);
}

double heading_miss(const Curve& curve, const Pose& to) {
  return std::abs(wrapped(end_of(curve).heading_rad - to.heading_rad));
}

Path path_of(const std::array<Curve, 3>& three) {
  Path path;
  for (const Curve& curve : three) path.push_back({curve, Gear::forward});
  return path;
}

}  // namespace

TEST_CASE("one clothoid joins any two headings over a chord", "[motion][clothoid]") {
  double worst = 0;
  double worst_heading = 0;
  double shortest = 10;
  for (int i = 1; i <= 1024; ++i) {
    for (int j = 1; j <= 1024; ++j) {
      const Pose from{{0, 0}, kPi * (i - 512) / 512};
      const Pose to{{1, 0}, kPi * (j - 512) / 512};
      const Curve curve = clothoid_between(from, to);
      // Written so that NaN fails.
      if (!(miss(curve, to) <= worst)) worst = miss(curve, to);
      worst_heading = std::max(worst_heading, heading_miss(curve, to));
      shortest = std::min(shortest, curve.length_m);
    }
  }
  CHECK(worst <= 1e-12);
  CHECK(worst_heading < 1e-14);
  CHECK(shortest >= 1 - 1e-15);
}

TEST_CASE("one clothoid joins any two poses at any distance", "[motion][clothoid]") {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> any{-1, 1};
  double worst = 0;
  double worst_heading = 0;
  for (int i = 0; i < 100000; ++i) {
    const double reach = std::pow(10, 3 * any(random));
    const Pose from{{}, kPi * any(random)};
    const Pose to{reach * Point{any(random), any(random)}, kPi * any(random)};
    const Curve curve = clothoid_between(from, to);
    if (!(miss(curve, to) <= worst)) worst = miss(curve, to);
    worst_heading = std::max(worst_heading, heading_miss(curve, to));
  }
  CHECK(worst <= 1e-12);
  CHECK(worst_heading < 2e-14);
}

TEST_CASE("one clothoid joins poses that face away from each other, round a thousand distances",
          "[motion][clothoid]") {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> any{0, 1};
  double worst = 0;
  double longest = 0;
  for (int i = 0; i < 20000; ++i) {
    const double off = std::pow(10, -2.5 + 2 * any(random));
    const double side = any(random) < 0.5 ? -1 : 1;
    const Pose from{{}, side * (kPi - off * any(random))};
    const Pose to{{1, 0}, -side * (kPi - off * any(random))};
    const Curve curve = clothoid_between(from, to);
    if (curve.length_m > 1024) continue;
    if (!(miss(curve, to) <= worst)) worst = miss(curve, to);
    longest = std::max(longest, curve.length_m);
  }
  CHECK(worst <= 1e-12);
  CHECK(longest > 1000);
}

TEST_CASE("the clothoid of symmetric headings is an arc, that of equal ones has no mean curvature",
          "[motion][clothoid]") {
  const Curve arc = clothoid_between({{0, 0}, 0.5}, {{2, 0}, -0.5});
  CHECK(std::abs(arc.sharpness_per_m2) < 1e-15);
  CHECK(arc.curvature_per_m == Approx(-std::sin(0.5)).epsilon(1e-14));
  CHECK(arc.length_m == Approx(1 / std::sin(0.5)).epsilon(1e-14));
  const Curve s_bend = clothoid_between({{0, 0}, 0.5}, {{2, 0}, 0.5});
  CHECK(s_bend.curvature_per_m == Approx(-end_of(s_bend).curvature_per_m).epsilon(1e-14));
  CHECK(clothoid_between({{1, 1}, 0}, {{4, 1}, 0}) == Curve{{1, 1}, 0, 0, 0, 3});
}

TEST_CASE("a mirrored pair of poses is joined by the mirrored clothoid", "[motion][clothoid]") {
  for (double start = -3; start < 3; start += 0.37) {
    for (double end = -3; end < 3; end += 0.41) {
      const Curve left = clothoid_between({{0, 0}, start}, {{1, 0}, end});
      const Curve right = clothoid_between({{0, 0}, -start}, {{1, 0}, -end});
      CHECK(left.curvature_per_m == Approx(-right.curvature_per_m));
      CHECK(left.length_m == Approx(right.length_m));
      CHECK(end_of(left).heading_rad - start == Approx(end - start).margin(1e-13));
    }
  }
}

TEST_CASE("poses at one point are joined by nothing", "[motion][clothoid]") {
  CHECK(clothoid_between({{1, 2}, 0}, {{1, 2}, 3}).length_m == 0);
  CHECK_FALSE(clothoids_between({{{1, 2}, 0}, 0}, {{{1, 2}, 3}, 0}).has_value());
}

TEST_CASE("three clothoids join any two poses with any curvatures", "[motion][clothoid]") {
  std::mt19937 random{4};
  std::uniform_real_distribution<double> any{-1, 1};
  int found = 0;
  Gaps gap;
  double worst = 0;
  double worst_bend = 0;
  const int tries = 4000;
  for (int i = 0; i < tries; ++i) {
    const double reach = std::pow(10, 1.5 * any(random));
    const double bend = std::pow(10, any(random)) / reach;
    const BentPose from{{{3, 4}, kPi * any(random)}, bend * any(random)};
    const BentPose to{{Point{3, 4} + reach * Point{any(random), any(random)}, kPi * any(random)},
                      bend * any(random)};
    const auto three = clothoids_between(from, to);
    if (!three) continue;
    ++found;
    const Path path = path_of(*three);
    const double unit_m = length_m(path);
    gap.position_m = std::max(gap.position_m, gaps(path).position_m / unit_m);
    gap.heading_rad = std::max(gap.heading_rad, gaps(path).heading_rad);
    gap.curvature_per_m = std::max(gap.curvature_per_m, gaps(path).curvature_per_m * reach);
    const CurveState end = end_of(three->back());
    worst = std::max({worst, distance_m(end.at, to.pose.at) / unit_m, heading_miss(three->back(), to.pose)});
    worst_bend = std::max(worst_bend, std::abs(end.curvature_per_m - to.curvature_per_m) * reach);
    CHECK(three->front().curvature_per_m == Approx(from.curvature_per_m).epsilon(1e-14));
    CHECK(three->front().start == from.pose.at);
    for (const Curve& curve : *three) CHECK(curve.length_m > 0);
  }
  CHECK(found == tries);
  CHECK(gap.position_m < 1e-12);
  CHECK(gap.heading_rad < 1e-9);
  CHECK(gap.curvature_per_m < 1e-9);
  CHECK(worst < 1e-12);
  CHECK(worst_bend < 1e-10);
}

TEST_CASE("three clothoids between places on one clothoid are that clothoid", "[motion][clothoid]") {
  const Curve whole{{1, 2}, 0.3, 0.05, 0.02, 6};
  const CurveState end = end_of(whole);
  const auto three = clothoids_between({{whole.start, whole.heading_rad}, whole.curvature_per_m},
                                       {{end.at, end.heading_rad}, end.curvature_per_m});
  REQUIRE(three.has_value());
  CHECK(length_m(path_of(*three)) == Approx(6).epsilon(1e-12));
  for (const Curve& curve : *three) CHECK(curve.sharpness_per_m2 == Approx(0.02).epsilon(1e-9));
}

TEST_CASE("a path keeps its own largest bend and no less", "[motion][clothoid]") {
  const Path path{{{{}, 0, -0.1, 0.05, 8}, Gear::forward}, {{{}, 0, 0.2, -0.08, 1}, Gear::forward}};
  const CurveLimits bend = largest_bend(path);
  CHECK(bend.curvature_per_m == Approx(0.3));
  CHECK(bend.sharpness_per_m2 == Approx(0.08));
  CHECK(keeps(path, bend));
  CHECK_FALSE(keeps(path, {0.299, 0.08}));
  CHECK_FALSE(keeps(path, {0.3, 0.079}));
  CHECK(largest_bend({}) == CurveLimits{});
}
