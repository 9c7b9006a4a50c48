// SPDX-License-Identifier: GPL-3.0-or-later
#include "swing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "displacement.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/turns.hpp"

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
  full_half_ = unit(full_rad_ / 2);
  // A machine that steers slowly may turn so far on the ramp that the series has lost its digits.
  const Point end = displacement({{}, 0, 0, limits.sharpness_per_m2, 0}, k / limits.sharpness_per_m2);
  full_ramp_ = turned(mirrored(full_half_), end);
  centre_ = end + (1 / k) * left_of(full_half_);
  reach_m_ = selion::length_m(centre_);
  lean_rad_ = std::atan2(centre_.x_m, centre_.y_m);
  std::array<Point, kParts + 1> ways;
  for (std::size_t i = 0; i <= kParts; ++i) {
    const double deflection = 2 * std::numbers::pi / kParts * static_cast<double>(i);
    const Point along = unit(deflection / 2);
    ways[i] = chord(deflection, along).length_m * along;
  }
  for (std::size_t i = 0; i <= kParts; ++i) {
    const Point ahead = unit(2 * std::numbers::pi / kParts * static_cast<double>(i));
    for (std::size_t k2 = 0; k2 <= kParts; ++k2)
      two_swings_[i][k2] = ways[i] + turned(ahead, mirrored(ways[k2]));
  }
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

double Swings::length_m(double deflection_rad) const {
  if (deflection_rad >= full_rad_)
    return deflection_rad / limits_.curvature_per_m + limits_.curvature_per_m / limits_.sharpness_per_m2;
  return 2 * std::sqrt(deflection_rad / limits_.sharpness_per_m2);
}

Point Swings::ramp(double deflection_rad, double length_m) {
  const Point means = clothoid_means(deflection_rad);
  return {length_m * means.x_m, -length_m * means.y_m};
}

void draw_line(Drawn& drawn, double length_m) {
  if (!(length_m > 0)) return;
  drawn.path.push_back({{drawn.at.at, drawn.at.heading_rad, 0, 0, length_m}, Gear::forward});
  drawn.at.at = drawn.at.at + length_m * drawn.ahead;
}

void draw_line_back(Drawn& drawn, double length_m) {
  if (!(length_m > 0)) return;
  const double heading_rad = wrapped(drawn.at.heading_rad + std::numbers::pi);
  drawn.path.push_back({{drawn.at.at, heading_rad, 0, 0, length_m}, Gear::reverse});
  drawn.at.at = drawn.at.at - length_m * drawn.ahead;
}

void draw_arc(Drawn& drawn, double curvature_per_m, double length_m, Point turn) {
  const double radius = 1 / curvature_per_m;
  draw_ramp(drawn, {curvature_per_m, 0, length_m, {radius * turn.y_m, radius * (1 - turn.x_m)}, turn});
}

void draw_pivot(Drawn& drawn, double angle_rad) {
  if (angle_rad == 0) return;
  drawn.path.push_back({{drawn.at.at, drawn.at.heading_rad, 0, 0, 0}, Gear::forward, angle_rad});
  drawn.at.heading_rad += angle_rad;
  drawn.ahead = turned(drawn.ahead, unit(angle_rad));
}

namespace {

Ramp arc(double curvature_per_m, double length_m) {
  const double half = curvature_per_m * length_m / 2;
  const Point half_turn = unit(half);
  // Short arcs: sin(half) / half without losing what it is divided by.
  const double chord =
      std::abs(half) < 1e-4 ? length_m * (1 - half * half / 6) : 2 * half_turn.y_m / curvature_per_m;
  const Point turn = turned(half_turn, half_turn);
  return {curvature_per_m, 0, length_m, chord * half_turn, turn};
}

}  // namespace

void draw_arc(Drawn& drawn, double curvature_per_m, double length_m) {
  if (length_m > 0) draw_ramp(drawn, arc(curvature_per_m, length_m));
}

void draw_arc_back(Drawn& drawn, double curvature_per_m, double length_m) {
  if (!(length_m > 0)) return;
  const Ramp back = arc(curvature_per_m, length_m);
  const double heading_rad = wrapped(drawn.at.heading_rad + std::numbers::pi);
  drawn.path.push_back({{drawn.at.at, heading_rad, curvature_per_m, 0, length_m}, Gear::reverse});
  drawn.at.at = drawn.at.at - turned(drawn.ahead, back.way);
  drawn.at.heading_rad += curvature_per_m * length_m;
  drawn.ahead = turned(drawn.ahead, back.turn);
}

void draw_ramp(Drawn& drawn, const Ramp& ramp) {
  // Written in place: copied right after its parts were written, a stretch waits until they have arrived.
  Curve& curve = drawn.path.emplace_back().curve;
  curve.start = drawn.at.at;
  curve.heading_rad = drawn.at.heading_rad;
  curve.curvature_per_m = ramp.curvature_per_m;
  curve.sharpness_per_m2 = ramp.sharpness_per_m2;
  curve.length_m = ramp.length_m;
  drawn.at.at = drawn.at.at + turned(drawn.ahead, ramp.way);
  drawn.at.heading_rad += (ramp.curvature_per_m + ramp.sharpness_per_m2 * ramp.length_m / 2) * ramp.length_m;
  drawn.ahead = turned(drawn.ahead, ramp.turn);
}

void draw_swing(Drawn& drawn, const Deflection& by, const Swings& swings) {
  if (by.rad == 0) return;
  const double side = by.rad < 0 ? -1 : 1;
  const SwingShape shape = swings.shape(side * by.rad);
  const bool full = shape.arc_m > 0;
  Point turn = full ? swings.full_half() : Point{by.half.x_m, side * by.half.y_m};
  Point ramp = full ? swings.full_ramp() : Swings::ramp(side * by.rad / 2, shape.clothoid_m);
  turn.y_m *= side;
  ramp.y_m *= side;
  const double k = side * shape.curvature_per_m;
  const double g = side * shape.sharpness_per_m2;
  draw_ramp(drawn, {0, g, shape.clothoid_m, turned(turn, ramp), turn});
  if (full) {
    const Point half_arc = turned(mirrored(turn), by.half);
    draw_arc(drawn, k, shape.arc_m, turned(half_arc, half_arc));
  }
  draw_ramp(drawn, {k, -g, shape.clothoid_m, mirrored(ramp), turn});
}

Path swing(const Pose& from, double deflection_rad, const Swings& swings) {
  Drawn drawn{from};
  draw_swing(drawn, deflection(deflection_rad), swings);
  return std::move(drawn.path);
}

Path swing(const Pose& from, double deflection_rad, const CurveLimits& limits) {
  return swing(from, deflection_rad, Swings{limits});
}

Corner corner_of(double deflection_rad, const CurveLimits& limits) {
  const Swings swings{limits};
  const double deflection = std::abs(deflection_rad);
  const double tangent = swings.chord(deflection).length_m / (2 * std::cos(deflection / 2));
  return {tangent, tangent * std::sin(deflection / 2) - swings.bulge_m(deflection)};
}

}  // namespace selion
