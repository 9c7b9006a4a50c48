// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion_curves.hpp"
#include "selion/motion/crossing.hpp"

using namespace selion;

namespace {

std::vector<Point> samples(const Curve& curve, int count) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) points.push_back(state_at(curve, curve.length_m * i / count).at);
  return points;
}

std::size_t crossings_of(const std::vector<Point>& p, const std::vector<Point>& q) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    for (std::size_t j = 1; j < q.size(); ++j) {
      const auto side = [](Point a, Point b, Point c) { return cross(b - a, c - a) > 0; };
      if (side(p[i - 1], p[i], q[j - 1]) == side(p[i - 1], p[i], q[j])) continue;
      if (side(q[j - 1], q[j], p[i - 1]) != side(q[j - 1], q[j], p[i])) ++count;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("curves cross as often as fine polylines of theirs, and where both are", "[motion][crossing]") {
  const auto curves = any_curves(160);
  std::size_t all = 0;
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const auto found = crossings(curves[i - 1], curves[i]);
    CAPTURE(i);
    CHECK(found.size() == crossings_of(samples(curves[i - 1], 1000), samples(curves[i], 1000)));
    CHECK(crossings(curves[i], curves[i - 1]).size() == found.size());
    for (const Crossing& crossing : found) {
      CHECK(distance_m(state_at(curves[i - 1], crossing.first_m).at, crossing.at) < 1e-12);
      CHECK(distance_m(state_at(curves[i], crossing.second_m).at, crossing.at) < 1e-9);
    }
    all += found.size();
  }
  CHECK(all > 20);
}

TEST_CASE("a line crosses a circle twice and touches its highest point once", "[motion][crossing]") {
  const Curve line{{-3, 0}, 0, 0, 0, 10};
  const Curve circle{{0, -1}, 0, 1, 0, 2 * std::numbers::pi - 1e-3};
  const auto twice = crossings(line, circle);
  REQUIRE(twice.size() == 2);
  CHECK(twice[0].first_m == Approx(2).epsilon(1e-14));
  CHECK(twice[1].first_m == Approx(4).epsilon(1e-14));
  const auto once = crossings({{-3, 1}, 0, 0, 0, 10}, circle);
  REQUIRE(once.size() == 1);
  CHECK(once[0].meeting == Meeting::touching);
  CHECK(once[0].first_m == Approx(3).margin(1e-9));
  CHECK(crossings({{-3, 1 + 1e-8}, 0, 0, 0, 10}, circle).empty());
}

TEST_CASE("curves that meet at their ends cross there", "[motion][crossing]") {
  const auto corner = crossings(line({0, 0}, {10, 0}), line({10, 0}, {10, 5}));
  REQUIRE(corner.size() == 1);
  CHECK(corner[0].first_m == Approx(10));
  CHECK(corner[0].second_m == Approx(0).margin(1e-9));
  const Curve clothoid{{0, 0}, 0, 0, 0.1, 5};
  const auto joint = crossings(line({-5, 0}, {0, 0}), clothoid);
  REQUIRE(joint.size() == 1);
  CHECK(joint[0].meeting == Meeting::touching);
  CHECK(joint[0].first_m == Approx(5).margin(1e-2));
}

TEST_CASE("parts of one curve overlap from end to end", "[motion][crossing]") {
  const Curve whole{{1, 2}, 0.3, -0.1, 0.05, 9};
  const CurveState inside = state_at(whole, 4);
  const Curve part{inside.at, inside.heading_rad, inside.curvature_per_m, 0.05, 12};
  for (const Curve& other : {part, reversed(part)}) {
    const auto shared = crossings(whole, other);
    REQUIRE(shared.size() == 2);
    CHECK(shared[0].meeting == Meeting::overlap);
    CHECK(shared[0].first_m == Approx(4).margin(1e-8));
    CHECK(shared[1].first_m == Approx(9).margin(1e-8));
  }
  CHECK(crossings({{0, 0}, 0, 0, 0, 5}, {{0, 1e-6}, 0, 0, 0, 5}).empty());
}

TEST_CASE("curves that nearly overlap are told apart without walking along them", "[motion][crossing]") {
  const Curve curve{{1, 2}, 0.3, -0.4, 0.08, 10};
  const auto beside = [&](double away_m) {
    Curve other = curve;
    other.start = curve.start + away_m * left_of(unit(curve.heading_rad));
    return other;
  };
  CHECK(crossings(curve, beside(1e-6)).empty());
  const auto near = crossings(curve, beside(5e-10));
  REQUIRE(near.size() == 2);
  CHECK(near[0].meeting == Meeting::overlap);
  CHECK(near[0].first_m == Approx(0).margin(2e-4));
  CHECK(near[1].first_m == Approx(10).margin(2e-4));
}

TEST_CASE("an overlap ends where the curves part", "[motion][crossing]") {
  // 1e-7/m bent: 1e-9 m, and 2e-9 m, away after sqrt(2e-2) m, and sqrt(4e-2) m.
  const Curve straight{{0, 0}, 0, 0, 0, 10};
  const Curve bent{{0, 0}, 0, 1e-7, 0, 10};
  for (const Curve& other : {bent, reversed(bent)}) {
    const auto shared = crossings(straight, other);
    REQUIRE(shared.size() == 2);
    CHECK(shared[0].meeting == Meeting::overlap);
    CHECK(shared[0].first_m == Approx(0).margin(2e-4));
    CHECK(shared[1].first_m >= 0.1414 - 2e-4);
    CHECK(shared[1].first_m <= 0.2 + 2e-4);
  }
}

TEST_CASE("the search for meetings is short, however near the curves are", "[motion][crossing]") {
  const auto began = std::chrono::steady_clock::now();
  for (const Curve& curve : {Curve{{1, 2}, 0.3, -0.4, 0.08, 10}, Curve{{1, 2}, 0.3, 1, 0, 6},
                             Curve{{1, 2}, 0.3, 0, 0, 10}, Curve{{1, 2}, 0.3, 0, 0.3, 10}}) {
    for (double away = 1e-11; away < 1e-3; away *= 3) {
      Curve other = curve;
      other.start = curve.start + away * left_of(unit(curve.heading_rad));
      crossings(curve, other);
      other.start = curve.start;
      other.heading_rad += away;
      crossings(curve, other);
      other.heading_rad = curve.heading_rad;
      other.curvature_per_m += away;
      crossings(curve, other);
      other.curvature_per_m = curve.curvature_per_m;
      other.sharpness_per_m2 += away;
      crossings(curve, other);
    }
  }
  // 272 searches, 12 ms each.
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  CHECK(took.count() < 60);
}
