// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "../src/motion/displacement.hpp"
#include "selion/core/angle.hpp"

using namespace selion;

namespace {

using Wide = long double;

struct WidePoint {
  Wide x = 0;
  Wide y = 0;
};

/// The ten-point Gauss-Legendre rule, by Newton's method on the Legendre polynomial.
std::array<WidePoint, 10> ten_points() {
  std::array<WidePoint, 10> rule;
  for (std::size_t i = 0; i < 10; ++i) {
    Wide x = std::cos(std::numbers::pi_v<Wide> * (static_cast<Wide>(i) + 0.75L) / 10.5L);
    Wide slope = 0;
    for (int step = 0; step < 20; ++step) {
      Wide last = 1;
      Wide now = x;
      for (int n = 2; n <= 10; ++n) {
        const Wide next = ((2 * n - 1) * x * now - (n - 1) * last) / n;
        last = now;
        now = next;
      }
      slope = 10 * (x * now - last) / (x * x - 1);
      x -= now / slope;
    }
    rule[i] = {x, 2 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

/// By panels over which the heading turns at most half a radian, in 64-bit mantissas.
Point displaced_slowly(const Curve& curve) {
  static const auto rule = ten_points();
  const Wide k = curve.curvature_per_m;
  const Wide c = curve.sharpness_per_m2;
  const Wide s = curve.length_m;
  const Wide phase = std::max(std::abs(k), std::abs(k + c * s)) * std::abs(s);
  const int panels = 1 + static_cast<int>(2 * phase);
  WidePoint sum;
  for (int i = 0; i < panels; ++i) {
    for (const WidePoint& node : rule) {
      const Wide u = s * (static_cast<Wide>(i) + (1 + node.x) / 2) / panels;
      const Wide heading = curve.heading_rad + (k + c * u / 2) * u;
      sum.x += node.y * std::cos(heading);
      sum.y += node.y * std::sin(heading);
    }
  }
  return {static_cast<double>(sum.x * s / (2 * panels)), static_cast<double>(sum.y * s / (2 * panels))};
}

double error_of(const Curve& curve) {
  return distance_m(displacement(curve, curve.length_m), displaced_slowly(curve));
}

}  // namespace

TEST_CASE("curves up to 1 km end where quadrature says, whatever their curvature and sharpness",
          "[motion][curve]") {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> exponent{-16, 0};
  std::uniform_real_distribution<double> any{-1, 1};
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const double length = 1000 * std::abs(any(random));
    const double curvature = any(random) * std::pow(10, exponent(random));
    // The end's curvature stays within 2/m.
    const double sharpness = any(random) * std::min(std::pow(10, exponent(random)), 1 / length);
    const Curve curve{{3, -4}, 3 * any(random), curvature, sharpness, length};
    const double error = error_of(curve);
    CAPTURE(curvature, sharpness, length);
    CHECK(error < 1e-10);
    worst = std::max(worst, error);
  }
  CHECK(worst > 0);  // the two are different computations
}

TEST_CASE("no seam shows where the way of computing a clothoid changes", "[motion][curve]") {
  for (const double curvature : {0.0, 1e-9, 0.01, 0.3, 1.0}) {
    for (double sharpness = 1e-14; sharpness < 0.1; sharpness *= 1.5) {
      for (double length = 1e-6; length < 900; length *= 1.7) {
        if (sharpness * length > 1) continue;
        CAPTURE(curvature, sharpness, length);
        CHECK(error_of({{}, 0.4, curvature, sharpness, length}) < 1e-11);
        CHECK(error_of({{}, 0.4, curvature, -sharpness, length}) < 1e-11);
      }
    }
  }
}

TEST_CASE("lines and arcs are exact", "[motion][curve]") {
  const CurveState end = end_of({{1, 2}, 0, 0, 0, 1000});
  CHECK(end.at == Point{1001, 2});
  const CurveState half = end_of({{0, 0}, 0, 0.1, 0, 10 * std::numbers::pi});
  CHECK(half.at.x_m == Approx(0).margin(1e-14));
  CHECK(half.at.y_m == Approx(20).epsilon(1e-15));
  CHECK(half.heading_rad == Approx(std::numbers::pi));
}

TEST_CASE("a curve can be evaluated before its start and past its end", "[motion][curve]") {
  const Curve curve{{5, 6}, 0.7, 0.2, -0.03, 4};
  const CurveState later = state_at(curve, 9);
  const Curve whole{later.at, later.heading_rad, later.curvature_per_m, curve.sharpness_per_m2, 0};
  const CurveState back = state_at(whole, -9);
  CHECK(distance_m(back.at, curve.start) < 1e-13);
  CHECK(back.heading_rad == Approx(curve.heading_rad));
  CHECK(back.curvature_per_m == Approx(curve.curvature_per_m));
}

TEST_CASE("a line leads from one point to the other", "[motion][path]") {
  const Curve l = line({1, 1}, {-2, 5});
  CHECK(l.length_m == Approx(5));
  CHECK(distance_m(end_of(l).at, {-2, 5}) < 1e-14);
}

TEST_CASE("a reversed curve passes the same points the other way", "[motion][path]") {
  const Curve curve{{5, 6}, 2.7, 0.2, -0.07, 8};
  const Curve back = reversed(curve);
  for (const double s : {0.0, 1.0, 3.5, 8.0}) {
    const CurveState there = state_at(curve, s);
    const CurveState here = state_at(back, 8 - s);
    CHECK(distance_m(there.at, here.at) < 1e-13);
    CHECK(std::abs(wrapped(there.heading_rad - here.heading_rad)) == Approx(std::numbers::pi));
    CHECK(here.curvature_per_m == Approx(-there.curvature_per_m).margin(1e-15));
  }
}

namespace {

Path two_stretches() {
  const Curve clothoid{{0, 0}, 0.3, 0, 0.1, 3};
  const CurveState joint = end_of(clothoid);
  return {{clothoid, Gear::forward}, {{joint.at, joint.heading_rad, 0.3, 0, 5}, Gear::forward}};
}

}  // namespace

TEST_CASE("a backed path has the same vehicle poses in the other order", "[motion][path]") {
  const Path path = two_stretches();
  const Path back = backed(path);
  CHECK(back.front().gear == Gear::reverse);
  CHECK(length_m(back) == length_m(path));
  CHECK(distance_m(start_pose(back).at, end_pose(path).at) < 1e-14);
  CHECK(std::abs(wrapped(start_pose(back).heading_rad - end_pose(path).heading_rad)) < 1e-14);
  CHECK(distance_m(end_pose(back).at, start_pose(path).at) < 1e-14);
  CHECK(gaps(back).position_m < 1e-14);
  CHECK(gaps(back).heading_rad < 1e-14);
  CHECK(gaps(back).curvature_per_m < 1e-14);
}

TEST_CASE("gaps are found where stretches do not meet", "[motion][path]") {
  Path path = two_stretches();
  CHECK(gaps(path).position_m == 0);
  path[1].curve.start = path[1].curve.start + Point{0.3, 0.4};
  path[1].curve.heading_rad += 2 * std::numbers::pi - 0.25;
  path[1].curve.curvature_per_m = 0.5;
  CHECK(gaps(path).position_m == Approx(0.5));
  CHECK(gaps(path).heading_rad == Approx(0.25));
  CHECK(gaps(path).curvature_per_m == Approx(0.2));
  path[1].gear = Gear::reverse;
  CHECK(gaps(path).curvature_per_m == 0);
}

TEST_CASE("poses stand at most a step apart and at both ends of every stretch", "[motion][path]") {
  const Path path = two_stretches();
  const auto all = poses(path, 0.7);
  REQUIRE(all.size() == 1 + 5 + 8);
  CHECK(all.front() == start_pose(path));
  CHECK(all.back() == end_pose(path));
  CHECK(distance_m(all[5].at, path[1].curve.start) < 1e-14);
  for (std::size_t i = 1; i < all.size(); ++i) CHECK(distance_m(all[i - 1].at, all[i].at) <= 0.7);
}
