// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "selion/core/units.hpp"
#include "selion/motion/depth.hpp"
#include "selion/motion/dubins.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;

struct Case {
  CurveLimits limits;
  double most_ratio;  // to Dubins' length, of all slants and widths
};
constexpr auto kCases = std::to_array<Case>(
    {{{0.27, 0.65}, 1.04}, {{0.271, 0.327}, 1.09}, {{0.556, 0.436}, 1.31}, {{0.15, 0.02}, 1.68}});

constexpr double kFlat_m = 7e-4;  // flat turns come first where others are shorter by as little

double shortest_m(const Pose& to, const Swings& swings) {
  double least_m = 1e300;
  for (const TurnKind& kind : turns())
    if (kind.needs == Needs::nothing)
      for (const Path& path : kind.candidates({}, to, swings)) least_m = std::min(least_m, length_m(path));
  return least_m;
}

}  // namespace

TEST_CASE("at any slant of the headland the shortest turn comes first and none loops needlessly",
          "[motion][turns]") {
  const auto& one = GENERATE(from_range(kCases.begin(), kCases.end()));
  const Swings swings{one.limits};
  double worst = 0;
  for (int slant_deg = -60; slant_deg <= 60; slant_deg += 15) {
    for (double aside_m = 0.5; aside_m <= 14; aside_m += 0.5) {
      const double ahead_m = aside_m * std::tan(radians_of_degrees(slant_deg));
      const Pose to{{ahead_m, aside_m}, kPi};
      const double first_m = length_m(*Connections{{}, to, swings}.next());
      const double even_m = length_m(*Connections{{}, {{0, aside_m}, kPi}, swings}.next());
      CAPTURE(one.limits.curvature_per_m, slant_deg, aside_m);
      REQUIRE(first_m <= even_m + std::abs(ahead_m) + 1e-9);  // the shorter swath driven on, then the U-turn
      REQUIRE(first_m <= shortest_m(to, swings) + (slant_deg == 0 ? kFlat_m : 1e-6));
      worst = std::max(worst, first_m / dubins_length_m({}, to, 1 / one.limits.curvature_per_m));
    }
  }
  CAPTURE(one.limits.curvature_per_m, one.limits.sharpness_per_m2);
  CHECK(worst <= one.most_ratio);
  CHECK(worst >= one.most_ratio - 0.02);  // as stated in docs/evidence.md
}

TEST_CASE("to a swath far aside the flat turn comes first wherever none is shorter by a millimetre",
          "[motion][turns]") {
  for (const CurveLimits& limits :
       {CurveLimits{0.27, 0.65}, {0.271, 0.327}, {0.6, 0.6}, {0.05, 0.05}, {0.6, 0.05}}) {
    const Swings swings{limits};
    const double flat_from_m = std::numbers::sqrt2 * swings.chord(kPi / 2).length_m;
    for (double share = 1.001; share < 1.8; share += 0.011) {
      CAPTURE(limits.curvature_per_m, limits.sharpness_per_m2, share);
      const Pose to{{0, share * flat_from_m}, kPi};
      REQUIRE(length_m(*Connections{{}, to, swings}.next()) <= shortest_m(to, swings) + kFlat_m);
    }
  }
}

TEST_CASE("a way to another heading is as long as its steering takes", "[motion][turns]") {
  // In L metres from straight to straight the heading changes by g L^2 / 4 at most.
  const CurveLimits limits{0.27, 0.65};
  const Swings swings{limits};
  std::mt19937 random{3};
  std::uniform_real_distribution<double> any{-1, 1};
  for (int i = 0; i < 500; ++i) {
    const Pose to{{2 * any(random), any(random)}, any(random)};
    const double least_m = 2 * std::sqrt(std::abs(to.heading_rad) / limits.sharpness_per_m2);
    REQUIRE(length_m(*Connections{{}, to, swings}.next()) >= least_m - 1e-9);
  }
}

TEST_CASE("the depth of a path is where it gets farthest", "[motion][depth]") {
  std::mt19937 random{5};
  std::uniform_real_distribution<double> any{-1, 1};
  const Swings swings{{0.27, 0.65}};
  for (int i = 0; i < 60; ++i) {
    const Pose from{{50 * any(random), 50 * any(random)}, 7 * any(random)};
    const Pose to{from.at + 12 * Point{any(random), any(random)}, 7 * any(random)};
    const double beyond_rad = 7 * any(random);
    const Point beyond = unit(beyond_rad);
    Connections ways{from, to, swings, Manoeuvres{.reverse = true}};
    while (const auto way = ways.next()) {
      double most_m = 0;
      for (const Pose& pose : poses(*way, 0.01)) most_m = std::max(most_m, dot(beyond, pose.at - from.at));
      const double depth = depth_m(*way, beyond_rad);
      REQUIRE(depth >= most_m - 1e-12);
      REQUIRE(depth <= most_m + 0.005 * 0.005 * 0.27 / 2 + 1e-12);  // between two samples
    }
  }
}

TEST_CASE("the depth of simple curves is known", "[motion][depth]") {
  const Path circle{{{{3, 4}, 0.5, 0.2, 0, 10 * kPi}}};  // of radius 5
  CHECK(depth_m(circle, 0.5) == Approx(5));
  CHECK(depth_m(circle, 0.5 + kPi / 2) == Approx(10));
  CHECK(depth_m(circle, 0.5 + kPi) == Approx(5));
  CHECK(depth_m(circle, 0.5 - kPi / 2) == Approx(0).margin(1e-12));
  const Path straight{{line({1, 1}, {4, 5})}};
  CHECK(depth_m(straight, heading_rad({3, 4})) == Approx(5));
  CHECK(depth_m(straight, heading_rad({-3, -4})) == 0);
  CHECK(depth_m({}, 1) == 0);
  // There and back to the start's heading, the curvature changing its sign on the way: farthest in between.
  const Path bent{{{{0, 0}, 0, 0.4, -0.2, 4}}};
  double most_m = 0;
  for (const Pose& pose : poses(bent, 0.0005)) most_m = std::max(most_m, dot(unit(2), pose.at));
  CHECK(depth_m(bent, 2) == Approx(most_m).margin(1e-7));
  const Pose to{{0, 4}, kPi};
  const Path turn = *Connections{{}, to, Swings{{0.271, 0.327}}}.next();
  CHECK(depth_m(turn, 0) == Approx(8.891).margin(0.001));
}
