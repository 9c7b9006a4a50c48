// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/depth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace selion {
namespace {

/// Where the curve has turned by `turned_rad`: k s + c s^2 / 2 = turned, without cancellation.
std::array<double, 2> turned_by(const Curve& curve, double turned_rad) {
  const double k = curve.curvature_per_m;
  const double c = curve.sharpness_per_m2;
  const double square = k * k + 2 * c * turned_rad;
  if (!(square >= 0)) return {-1, -1};
  const double sum = k + std::copysign(std::sqrt(square), k);
  if (sum == 0) return {-1, -1};
  return {2 * turned_rad / sum, c == 0 ? -1 : -sum / c};
}

/// The headings at the curve's ends, and at the turning point between where the curvature changes its sign.
std::array<double, 2> turned_range(const Curve& curve) {
  const double end = (curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m / 2) * curve.length_m;
  double low = std::min(0.0, end);
  double high = std::max(0.0, end);
  if (curve.curvature_per_m * (curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m) < 0) {
    const double turn = -curve.curvature_per_m * curve.curvature_per_m / (2 * curve.sharpness_per_m2);
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  return {low, high};
}

double depth_of(const Curve& curve, Point start, double heading_rad) {
  const Point beyond = unit(heading_rad);
  double most = std::max(dot(beyond, curve.start - start), dot(beyond, end_of(curve).at - start));
  const double square = heading_rad + std::numbers::pi / 2 - curve.heading_rad;
  const auto [low, high] = turned_range(curve);
  for (double n = std::ceil((low - square) / std::numbers::pi); square + n * std::numbers::pi <= high; ++n)
    for (const double s : turned_by(curve, square + n * std::numbers::pi))
      if (s > 0 && s < curve.length_m) most = std::max(most, dot(beyond, state_at(curve, s).at - start));
  return most;
}

}  // namespace

double depth_m(const Path& path, double heading_rad) {
  double most = 0;
  for (const Stretch& stretch : path)
    most = std::max(most, depth_of(stretch.curve, path.front().curve.start, heading_rad));
  return most;
}

}  // namespace selion
