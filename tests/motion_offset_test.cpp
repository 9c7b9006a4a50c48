// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>

#include "motion_curves.hpp"
#include "selion/motion/offset.hpp"

using namespace selion;

namespace {

/// Curves with an offset that has no cusp.
std::vector<OffsetCurve> smooth_offsets() {
  std::vector<OffsetCurve> offsets;
  for (const Curve& curve : any_curves(300)) {
    for (const double d : {-3.0, -0.4, 0.02, 1.5}) {
      if (least_stretching({curve, d}) > 0.05) offsets.push_back({curve, d});
    }
  }
  return offsets;
}

}  // namespace

TEST_CASE("an offset's curvature is its heading's change per metre driven", "[motion][offset]") {
  for (const OffsetCurve& offset : smooth_offsets()) {
    const double s = 0.4 * offset.guide.length_m;
    const double step = 1e-4 * std::min(1.0, offset.guide.length_m);
    const auto before = state_at(offset, s - step);
    const auto at = state_at(offset, s);
    const auto after = state_at(offset, s + step);
    REQUIRE((before && at && after));
    const double way = length_to_m(offset, s + step) - length_to_m(offset, s - step);
    CAPTURE(offset.offset_m, offset.guide.curvature_per_m, offset.guide.sharpness_per_m2);
    CHECK(distance_m(before->at, after->at) == Approx(way).epsilon(1e-4));
    CHECK((after->heading_rad - before->heading_rad) / way ==
          Approx(at->curvature_per_m).margin(1e-6).epsilon(1e-4));
    CHECK((after->curvature_per_m - before->curvature_per_m) / way ==
          Approx(at->sharpness_per_m2).margin(1e-5).epsilon(1e-3));
    CHECK(at->stretching == Approx(way / (2 * step)).epsilon(1e-6));
  }
}

TEST_CASE("an offset is as long as its fine polyline", "[motion][offset]") {
  const OffsetCurve offset{{{1, 2}, 0.3, -0.1, 0.05, 9}, 1.7};
  double sum = 0;
  for (int i = 0; i < 2000; ++i)
    sum += distance_m(state_at(offset, 9 * i / 2000.0)->at, state_at(offset, 9 * (i + 1) / 2000.0)->at);
  CHECK(length_m(offset) == Approx(sum).epsilon(1e-6));
  CHECK(length_m(OffsetPath{{{offset.guide, Gear::forward}, {offset.guide, Gear::forward}}, 1.7}) ==
        Approx(2 * sum).epsilon(1e-6));
}

TEST_CASE("the offset of an arc is an arc about the same centre", "[motion][offset]") {
  const OffsetCurve inner{{{2, 0}, std::acos(0.0), 0.5, 0, 3}, 0.5};
  CHECK(state_at(inner, 3)->curvature_per_m == Approx(1 / 1.5));
  CHECK(length_m(inner) == Approx(3 * 0.75));
  CHECK(length_m(state_at(inner, 1.1)->at) == Approx(1.5));
}

TEST_CASE("the station of an offset's length is the length's inverse", "[motion][offset]") {
  for (const OffsetCurve& offset : smooth_offsets()) {
    const double s = 0.7 * offset.guide.length_m;
    const auto back = station_m(offset, length_to_m(offset, s));
    REQUIRE(back.has_value());
    CHECK(*back == Approx(s).epsilon(1e-10));
  }
  CHECK_FALSE(station_m({{{}, 0, 0, 0.1, 20}, 1}, 6).has_value());
}

TEST_CASE("a cusp is where curvature times offset reaches 1, and nowhere else", "[motion][offset]") {
  const Curve curve{{}, 0, -0.25, 0.125, 6};  // curvature -0.25 to 0.5
  CHECK(has_cusp(OffsetCurve{curve, 2}));
  CHECK_FALSE(has_cusp(OffsetCurve{curve, 2 - 1e-12}));
  CHECK(has_cusp(OffsetCurve{curve, -4}));
  CHECK_FALSE(has_cusp(OffsetCurve{curve, -4 + 1e-12}));
  CHECK_FALSE(state_at(OffsetCurve{curve, 2}, 6).has_value());
  CHECK(state_at(OffsetCurve{curve, 2}, 5.9).has_value());
  CHECK(has_cusp(OffsetPath{{{{}, Gear::forward}, {curve, Gear::forward}}, 3}));
  CHECK_FALSE(largest_bend(OffsetCurve{curve, 2}).has_value());
  CHECK_FALSE(keeps(OffsetCurve{curve, 2}, {1e9, 1e9}));
}

TEST_CASE("no sample of an offset bends more than its largest bend, and one does as much",
          "[motion][offset]") {
  for (const OffsetCurve& offset : smooth_offsets()) {
    const auto bend = largest_bend(offset);
    REQUIRE(bend.has_value());
    CurveLimits sampled;
    for (int i = 0; i <= 100; ++i) {
      const auto state = state_at(offset, offset.guide.length_m * i / 100);
      sampled.curvature_per_m = std::max(sampled.curvature_per_m, std::abs(state->curvature_per_m));
      sampled.sharpness_per_m2 = std::max(sampled.sharpness_per_m2, std::abs(state->sharpness_per_m2));
    }
    CHECK(bend->curvature_per_m == Approx(sampled.curvature_per_m).epsilon(1e-12));
    CHECK(bend->sharpness_per_m2 == Approx(sampled.sharpness_per_m2).epsilon(1e-12));
    CHECK(keeps(offset, *bend));
    if (bend->curvature_per_m > 0) CHECK_FALSE(keeps(offset, {0.999 * bend->curvature_per_m, 1e9}));
    if (bend->sharpness_per_m2 > 0) CHECK_FALSE(keeps(offset, {1e9, 0.999 * bend->sharpness_per_m2}));
  }
}
