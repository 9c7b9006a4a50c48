// SPDX-License-Identifier: GPL-3.0-or-later
#include "beside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "selion/core/point.hpp"

// The distance to the other curve, signed, is nearly a cubic along a short stretch: the headings, curvatures
// and sharpnesses differ. A cubic is known from four places; where they are Chebyshev's, it strays from a
// value by at most 5/3 of what it does there (Lebesgue's constant).
namespace selion {
namespace {

constexpr double kLebesgue = 5.0 / 3;

struct Foot {
  double station_m = 0;
  double left_m = 0;  ///< how far left of the curve the point is
};

std::optional<Foot> foot_on(const Curve& curve, Stations near, Point p) {
  constexpr double kMet_m = 1e-12;
  double at = (near.from_m + near.to_m) / 2;
  for (int i = 0; i < 8; ++i) {
    const CurveState state = state_at(curve, at);
    const Point ahead = unit(state.heading_rad);
    const double forwards = dot(p - state.at, ahead);
    at += forwards;
    if (at < 0 || at > curve.length_m) return std::nullopt;
    if (std::abs(forwards) <= kMet_m * (1 + curve.length_m)) return Foot{at, cross(ahead, p - state.at)};
  }
  return std::nullopt;
}

double largest_curvature(const Curve& curve, Stations stretch) {
  return std::max(std::abs(curve.curvature_per_m + curve.sharpness_per_m2 * stretch.from_m),
                  std::abs(curve.curvature_per_m + curve.sharpness_per_m2 * stretch.to_m));
}

/// What the cubic may leave out: the remainder is length^4 / 1536 times the fourth derivative.
double remainder_m(const Curve& curve, Stations stretch) {
  const double k = largest_curvature(curve, stretch);
  const double length = stretch.to_m - stretch.from_m;
  return k * (k * k + std::abs(curve.sharpness_per_m2)) * std::pow(length, 4) / 256;
}

}  // namespace

std::optional<Beside> beside(const Curve& curve, Stations stretch, const Curve& other, Stations near) {
  constexpr double kSmallRest_m = 1e-10;
  const double rest = remainder_m(curve, stretch) + remainder_m(other, near);
  std::array<Foot, 4> feet;
  constexpr std::array<double, 4> kShares{0, 0.25, 0.75, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    const double s = stretch.from_m + kShares[i] * (stretch.to_m - stretch.from_m);
    const auto foot = foot_on(other, near, state_at(curve, s).at);
    if (!foot || rest > std::max(kSmallRest_m, std::abs(foot->left_m) / 2)) return std::nullopt;
    feet[i] = *foot;
  }
  const auto [low, high] = std::minmax_element(
      feet.begin(), feet.end(), [](const Foot& a, const Foot& b) { return a.left_m < b.left_m; });
  const double middle = std::abs(low->left_m + high->left_m) / 2;
  const double spread = kLebesgue * (high->left_m - low->left_m) / 2 + rest;
  return Beside{middle - spread, middle + spread, {feet.front().station_m, feet.back().station_m}};
}

}  // namespace selion
