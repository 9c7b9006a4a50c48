// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/direction.hpp"
#include "motion/displacement.hpp"
#include "motion/fresnel.hpp"
#include "motion_clothoid_reference.hpp"
#include "motion_fresnel_reference.hpp"

using namespace selion;

TEST_CASE("Fresnel integrals are within 5e-16 of 60-digit values", "[motion][fresnel]") {
  for (const auto& [place, c, s] : kFresnelReference) {
    const auto t = static_cast<double>(place);
    const FresnelPair pair = fresnel(t);
    CAPTURE(t);
    CHECK(std::abs(pair.c - c) < 5e-16L);
    CHECK(std::abs(pair.s - s) < 5e-16L);
  }
}

TEST_CASE("Fresnel integrals keep their digits near 0", "[motion][fresnel]") {
  for (const auto& [place, c, s] : kFresnelReference) {
    const auto t = static_cast<double>(place);
    if (std::abs(t) > 0.7 || std::abs(t) < 1e-90) continue;
    CAPTURE(t);
    CHECK(std::abs(fresnel(t).c - c) <= 4e-16L * std::abs(c));
    CHECK(std::abs(fresnel(t).s - s) <= 4e-16L * std::abs(s));
  }
}

TEST_CASE("Fresnel integrals are odd and tend to a half", "[motion][fresnel]") {
  for (double t = 1e-3; t < 1e18; t *= 1.7) {
    CAPTURE(t);
    CHECK(fresnel(-t).c == -fresnel(t).c);
    CHECK(fresnel(-t).s == -fresnel(t).s);
    if (t > 1) CHECK(std::hypot(fresnel(t).c - 0.5, fresnel(t).s - 0.5) < 1 / (std::numbers::pi * t) + 5e-16);
  }
}

TEST_CASE("a direction agrees with long double sine and cosine, small and large", "[motion][direction]") {
  for (double angle = 1e-9; angle < 1e9; angle *= 1.003) {
    const double low = 4e-17 * angle;
    const Point way = direction({angle, low});
    const long double exact = static_cast<long double>(angle) + low;
    CAPTURE(angle);
    // Beyond 6e6 the cosine of the C library takes over.
    CHECK(std::abs(way.x_m - std::cos(exact)) < 1.7e-16L + 1e-19L * exact);
    CHECK(std::abs(way.y_m - std::sin(exact)) < 1.7e-16L + 1e-19L * exact);
  }
}

TEST_CASE("clothoids of any shape end within 4e-16 of their length of 60-digit values", "[motion][curve]") {
  for (const auto& [k, c, s, x, y] : kClothoidReference) {
    const Curve curve{{}, 0, static_cast<double>(k), static_cast<double>(c), static_cast<double>(s)};
    const Point end = displacement(curve, curve.length_m);
    CAPTURE(curve.curvature_per_m, curve.sharpness_per_m2, curve.length_m);
    CHECK(std::hypot(end.x_m - x, end.y_m - y) < 4e-16L * s);
  }
}

TEST_CASE("a turned or mirrored clothoid is the clothoid turned or mirrored", "[motion][curve]") {
  for (const auto& [k, c, s, x, y] : kClothoidReference) {
    Curve curve{{}, 0.7, static_cast<double>(k), static_cast<double>(c), static_cast<double>(s)};
    const Point end = displacement(curve, curve.length_m);
    const Point along = unit(0.7);
    const Point expected = static_cast<double>(x) * along + static_cast<double>(y) * left_of(along);
    CHECK(distance_m(end, expected) < 7e-16 * curve.length_m);
    curve = {{}, -0.7, -curve.curvature_per_m, -curve.sharpness_per_m2, curve.length_m};
    CHECK(displacement(curve, curve.length_m) == Point{end.x_m, -end.y_m});
  }
}
