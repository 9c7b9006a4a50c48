// SPDX-License-Identifier: GPL-3.0-or-later
#include "swing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "displacement.hpp"

namespace selion {
namespace {

// An arc shorter than this is left out: the clothoids then are as much less sharp as it takes.
constexpr double kNoArc_m = 1e-10;

constexpr auto kSteps = [] {
  std::array<double, 60> steps{};
  for (std::size_t n = 0; n < steps.size(); ++n) steps[n] = 2.0 / static_cast<double>(2 * n + 3);
  return steps;
}();

/// Means of cos and sin of phi (1 - t^2) over t in [0, 1]: how a clothoid that deflects by phi lies along and
/// across its end's heading, per length. The n-th term is phi^n / n! times the mean of (1 - t^2)^n.
Point clothoid_means(double phi) {
  Point means;
  double term = 1;
  for (std::size_t n = 0; n < kSteps.size() && std::abs(term) > 1e-17; n += 2) {
    means.x_m += term;
    term *= phi * kSteps[n];
    means.y_m += term;
    term *= -phi * kSteps[n + 1];
  }
  return means;
}

}  // namespace

CurveLimits limits_at(const Machine& machine, double speed_mps) {
  return {max_curvature_per_m(machine), max_sharpness_per_m2(machine, speed_mps)};
}

Swings::Swings(const CurveLimits& limits) : limits_{limits} {
  const double k = limits.curvature_per_m;
  full_rad_ = k * k / limits.sharpness_per_m2;
  const Point end = displacement({{}, 0, 0, limits.sharpness_per_m2, 0}, k / limits.sharpness_per_m2);
  centre_ = end + (1 / k) * left_of(unit(full_rad_ / 2));
}

SwingShape Swings::shape(double deflection_rad) const {
  const double arc = (deflection_rad - full_rad_) / limits_.curvature_per_m;
  if (arc > kNoArc_m) {
    return {limits_.curvature_per_m, limits_.sharpness_per_m2,
            limits_.curvature_per_m / limits_.sharpness_per_m2, arc};
  }
  const double peak = std::min(std::sqrt(limits_.sharpness_per_m2 * deflection_rad), limits_.curvature_per_m);
  return {peak, peak * peak / deflection_rad, deflection_rad / peak, 0};
}

Chord Swings::chord(double deflection_rad) const {
  return chord(deflection_rad, deflection_rad >= full_rad_ ? unit(deflection_rad / 2) : Point{});
}

Chord Swings::chord(double deflection_rad, Point direction) const {
  if (deflection_rad >= full_rad_) return {2 * dot(centre_, direction), cross(direction, centre_)};
  if (deflection_rad == 0) return {};
  const double clothoid = std::sqrt(deflection_rad / limits_.sharpness_per_m2);
  const Point means = clothoid_means(deflection_rad / 2);
  const double means_slope = -means.y_m - (means.x_m - 1) / deflection_rad;
  return {2 * clothoid * means.x_m, clothoid * (means.x_m / deflection_rad + means_slope)};
}

double Swings::bulge_m(double deflection_rad) const {
  const double half = deflection_rad / 2;
  if (deflection_rad >= full_rad_) return 1 / limits_.curvature_per_m - cross(unit(half), centre_);
  return std::sqrt(deflection_rad / limits_.sharpness_per_m2) * clothoid_means(half).y_m;
}

void draw(Drawn& drawn, double curvature_per_m, double sharpness_per_m2, double length_m) {
  const Curve curve{drawn.at.at, drawn.at.heading_rad, curvature_per_m, sharpness_per_m2, length_m};
  drawn.path.push_back({curve, Gear::forward});
  const CurveState end = end_of(curve);
  drawn.at = {end.at, end.heading_rad};
}

void draw_line(Drawn& drawn, double length_m) {
  if (length_m > 0) draw(drawn, 0, 0, length_m);
}

void draw_swing(Drawn& drawn, double deflection_rad, const Swings& swings) {
  if (deflection_rad == 0) return;
  const double side = deflection_rad > 0 ? 1 : -1;
  const SwingShape shape = swings.shape(std::abs(deflection_rad));
  draw(drawn, 0, side * shape.sharpness_per_m2, shape.clothoid_m);
  if (shape.arc_m > 0) draw(drawn, side * shape.curvature_per_m, 0, shape.arc_m);
  draw(drawn, side * shape.curvature_per_m, -side * shape.sharpness_per_m2, shape.clothoid_m);
}

Path swing(const Pose& from, double deflection_rad, const CurveLimits& limits) {
  Drawn drawn{{}, from};
  draw_swing(drawn, deflection_rad, Swings{limits});
  return drawn.path;
}

Corner corner_of(double deflection_rad, const CurveLimits& limits) {
  const Swings swings{limits};
  const double deflection = std::abs(deflection_rad);
  const double tangent = swings.chord(deflection).length_m / (2 * std::cos(deflection / 2));
  return {tangent, tangent * std::sin(deflection / 2) - swings.bulge_m(deflection)};
}

}  // namespace selion
