// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "motion_curves.hpp"
#include "selion/motion/nearest.hpp"

using namespace selion;

namespace {

constexpr int kSamples = 3000;

Point sample(const Curve& curve, int i) { return state_at(curve, curve.length_m * i / kSamples).at; }

}  // namespace

TEST_CASE("no sample of a curve is nearer than its nearest point", "[motion][nearest]") {
  for (const Curve& curve : any_curves(300)) {
    const Point place{3 * std::sin(100 * curve.length_m), 9 * std::cos(70 * curve.length_m)};
    const Nearest nearest = nearest_on(curve, place);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSamples; ++i) least = std::min(least, distance_m(sample(curve, i), place));
    CAPTURE(curve.curvature_per_m, curve.sharpness_per_m2, curve.length_m);
    CHECK(std::abs(nearest.offset_m) <= least + 1e-13);
    CHECK(distance_m(nearest.at, place) == Approx(std::abs(nearest.offset_m)).epsilon(1e-14));
    CHECK(nearest.at == state_at(curve, nearest.station_m).at);
    CHECK(nearest.station_m >= 0);
    CHECK(nearest.station_m <= curve.length_m);
  }
}

TEST_CASE("a place beside a curve is found again with its offset's sign", "[motion][nearest]") {
  for (const Curve& curve : any_curves(300)) {
    const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
    const double largest = std::max(std::abs(curve.curvature_per_m), std::abs(end));
    for (const double side : {-1.0, 1.0}) {
      // So near that no other part of the curve can be nearer, were it not for spirals: hence at most.
      const double offset = side * std::min(1.0, 0.2 / largest);
      const CurveState beside = state_at(curve, 0.6 * curve.length_m);
      const Point place = beside.at + offset * left_of(unit(beside.heading_rad));
      const Nearest nearest = nearest_on(curve, place);
      CHECK(std::abs(nearest.offset_m) <= std::abs(offset) + 1e-13);
      if (std::abs(std::abs(nearest.offset_m) - std::abs(offset)) > 1e-9) continue;
      if (std::abs(nearest.station_m - 0.6 * curve.length_m) > 1e-5) continue;
      CHECK(nearest.offset_m == Approx(offset).margin(1e-12));
    }
  }
}

TEST_CASE("the nearest point of a circle's centre is anywhere on it, and costs little", "[motion][nearest]") {
  const Curve circle{{1, 0}, std::numbers::pi / 2, 1, 0, 60};
  CHECK(nearest_on(circle, {0, 0}).offset_m == Approx(1).epsilon(1e-14));
  CHECK(nearest_on(circle, {3, 0}).offset_m == Approx(-2).epsilon(1e-14));
}

TEST_CASE("beyond its ends a line's nearest point is the end", "[motion][nearest]") {
  const Curve line{{1, 1}, 0, 0, 0, 5};
  CHECK(nearest_on(line, {-2, 5}).station_m == 0);
  CHECK(nearest_on(line, {-2, 5}).offset_m == Approx(5));
  CHECK(nearest_on(line, {9, -2}).station_m == 5);
  CHECK(nearest_on(line, {9, -2}).offset_m == Approx(-std::sqrt(18)));
  CHECK(nearest_on(line, {3, 1}).offset_m == 0);
}

TEST_CASE("the nearest point of a path is that of its nearest stretch", "[motion][nearest]") {
  Path path;
  Curve next{{0, 0}, 0.2, 0, 0.1, 4};
  for (int i = 0; i < 12; ++i) {
    path.push_back({next, Gear::forward});
    const CurveState end = end_of(next);
    next = {end.at, end.heading_rad, end.curvature_per_m, i % 2 == 0 ? -0.1 : 0.1, 3.0 + i};
  }
  for (double x = -10; x < 40; x += 2.3) {
    for (double y = -20; y < 30; y += 3.1) {
      const auto nearest = nearest_on(path, {x, y});
      REQUIRE(nearest.has_value());
      double least = std::numeric_limits<double>::infinity();
      double begun = 0;
      double station = 0;
      for (const Stretch& stretch : path) {
        const Nearest one = nearest_on(stretch.curve, {x, y});
        if (std::abs(one.offset_m) < least - 1e-12) station = begun + one.station_m;
        least = std::min(least, std::abs(one.offset_m));
        begun += stretch.curve.length_m;
      }
      CHECK(std::abs(nearest->offset_m) == Approx(least).epsilon(1e-13));
      CHECK(nearest->station_m == Approx(station).margin(1e-6));
    }
  }
  CHECK_FALSE(nearest_on(Path{}, {0, 0}).has_value());
}

TEST_CASE("a curve's box holds every sample and is no larger than they need", "[motion][nearest]") {
  for (const Curve& curve : any_curves(500)) {
    const Box box = box_of(curve);
    Box sampled{curve.start, curve.start};
    for (int i = 0; i <= kSamples; ++i) {
      const Point p = sample(curve, i);
      sampled.low = {std::min(sampled.low.x_m, p.x_m), std::min(sampled.low.y_m, p.y_m)};
      sampled.high = {std::max(sampled.high.x_m, p.x_m), std::max(sampled.high.y_m, p.y_m)};
    }
    CAPTURE(curve.curvature_per_m, curve.sharpness_per_m2, curve.length_m, curve.heading_rad);
    const double step = curve.length_m / kSamples;
    const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
    const double between = std::max(std::abs(curve.curvature_per_m), std::abs(end)) * step * step / 8 + 1e-12;
    for (const auto& [inner, outer] : {std::pair{sampled.low, box.low}, std::pair{box.high, sampled.high}}) {
      CHECK(inner.x_m - outer.x_m >= -1e-12);
      CHECK(inner.x_m - outer.x_m <= between);
      CHECK(inner.y_m - outer.y_m >= -1e-12);
      CHECK(inner.y_m - outer.y_m <= between);
    }
  }
  CHECK_FALSE(box_of(Path{}).has_value());
  const Box both =
      *box_of(Path{{line({0, 0}, {1, 2}), Gear::forward}, {line({1, 2}, {4, -1}), Gear::forward}});
  CHECK(both.low.x_m == 0);
  CHECK(both.low.y_m == Approx(-1));
  CHECK(both.high.x_m == Approx(4));
  CHECK(both.high.y_m == Approx(2));
}
