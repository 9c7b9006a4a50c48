// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "displacement.hpp"
#include "families.hpp"
#include "offer.hpp"
#include "root.hpp"

namespace selion {
namespace {

constexpr double kNoCurve_m = 1e-12;

/// A turn to the left whose curvature rises, dips to `dip_per_m` in its middle, rises again and ends at 0.
struct Dip {
  double dip_per_m = 0;
  double first_rad = 0;  ///< deflection up to the middle
  double second_rad = 0;
};

/// Half of a dip: clothoid up to the peak, arc, clothoid down to the dip.
struct Half {
  double peak_per_m = 0;
  double up_m = 0;
  double arc_m = 0;
  double down_m = 0;
};

/// Deflection of a half without an arc at the curvature limit.
double arcless_rad(double dip_per_m, const CurveLimits& limits) {
  const double k = limits.curvature_per_m;
  return (2 * k * k - dip_per_m * dip_per_m) / (2 * limits.sharpness_per_m2);
}

/// Empty where so small a deflection does not reach the curvature of the dip.
std::optional<Half> half_of(double dip_per_m, double deflection_rad, const CurveLimits& limits) {
  const double g = limits.sharpness_per_m2;
  const double arc = (deflection_rad - arcless_rad(dip_per_m, limits)) / limits.curvature_per_m;
  const double square = g * deflection_rad + dip_per_m * dip_per_m / 2;
  if (!(square >= 0)) return std::nullopt;
  const double peak = arc >= 0 ? limits.curvature_per_m : std::min(std::sqrt(square), limits.curvature_per_m);
  if (peak < dip_per_m * (1 - 1e-12) || dip_per_m < 0) return std::nullopt;
  return Half{peak, peak / g, std::max(arc, 0.0), std::max(peak - dip_per_m, 0.0) / g};
}

void draw_some(Drawn& drawn, double curvature_per_m, double sharpness_per_m2, double length_m) {
  if (length_m > kNoCurve_m) draw(drawn, curvature_per_m, sharpness_per_m2, length_m);
}

/// The left turn, or mirrored for side -1. @pre both halves exist.
void draw_dip(Drawn& drawn, const Dip& dip, int side, const CurveLimits& limits) {
  const Half first = *half_of(dip.dip_per_m, dip.first_rad, limits);
  const Half second = *half_of(dip.dip_per_m, dip.second_rad, limits);
  const double s = side;
  const double g = s * limits.sharpness_per_m2;
  draw_some(drawn, 0, g, first.up_m);
  draw_some(drawn, s * first.peak_per_m, 0, first.arc_m);
  draw_some(drawn, s * first.peak_per_m, -g, first.down_m);
  draw_some(drawn, s * (second.peak_per_m - limits.sharpness_per_m2 * second.down_m), g, second.down_m);
  draw_some(drawn, s * second.peak_per_m, 0, second.arc_m);
  draw_some(drawn, s * second.peak_per_m, -g, second.up_m);
}

Point rotated(double angle_rad, Point p) { return placed({{}, angle_rad}, p); }

/// Where half a dip leads from the origin, heading east.
Point way_of(const Half& half, double sharpness_per_m2) {
  const Curve up{{}, 0, 0, sharpness_per_m2, half.up_m};
  const Curve arc{{}, half.peak_per_m * half.up_m / 2, half.peak_per_m, 0, half.arc_m};
  const Curve down{
      {}, arc.heading_rad + half.peak_per_m * half.arc_m, half.peak_per_m, -sharpness_per_m2, half.down_m};
  return displacement(up, half.up_m) + displacement(arc, half.arc_m) + displacement(down, half.down_m);
}

/// Where the whole dip leads: its second half is the mirror image of a first one.
std::optional<Point> way_of(const Dip& dip, const CurveLimits& limits) {
  const auto first = half_of(dip.dip_per_m, dip.first_rad, limits);
  const auto second = half_of(dip.dip_per_m, dip.second_rad, limits);
  if (!first || !second) return std::nullopt;
  const Point back = way_of(*second, limits.sharpness_per_m2);
  return way_of(*first, limits.sharpness_per_m2) +
         rotated(dip.first_rad + dip.second_rad, {back.x_m, -back.y_m});
}

/// Both halves with an arc at the curvature limit: the two arcs' centres fix the middle's heading, and their
/// distance the dip.
std::optional<Dip> dip_between_arcs(const Pose& goal, double deflection_rad, const Swings& swings) {
  const CurveLimits& limits = swings.limits();
  const double k = limits.curvature_per_m;
  const double g = limits.sharpness_per_m2;
  const Point centre = swings.centre();
  const Point between = goal.at - rotated(deflection_rad, {centre.x_m, -centre.y_m}) - centre;
  const double apart = length_m(between);
  if (apart == 0 || apart >= 2 * centre.x_m) return std::nullopt;
  const auto excess = [&](double dip) {
    const double down = (k - dip) / g;
    const Point middle = displacement({{}, 0, k, -g, down}, down) - Point{0, 1 / k};
    return 2 * dot(middle, unit((k * k - dip * dip) / (2 * g))) - apart;
  };
  const double dip = root_between({0, 2 * centre.x_m - apart}, {k, -apart}, excess);
  const double first = whole_turns_off(heading_rad(between));
  if (std::min(first, deflection_rad - first) < arcless_rad(dip, limits)) return std::nullopt;
  return Dip{dip, first, deflection_rad - first};
}

/// The dip with two equal halves that leads as far as the goal is away.
std::optional<Dip> even_dip(const Pose& goal, double deflection_rad, const Swings& swings) {
  const CurveLimits& limits = swings.limits();
  const double half = deflection_rad / 2;
  const double apart = length_m(goal.at);
  const auto excess = [&](double dip) {
    return 2 * dot(way_of(*half_of(dip, half, limits), limits.sharpness_per_m2), unit(half)) - apart;
  };
  const double most = std::min(limits.curvature_per_m, std::sqrt(limits.sharpness_per_m2 * deflection_rad));
  const RootEnd widest{0, excess(0)};
  const RootEnd closest{most, swings.chord(deflection_rad).length_m - apart};
  if (widest.y < 0 || closest.y > 0) return std::nullopt;
  return Dip{root_between(widest, closest, excess), half, half};
}

/// Brought to the goal by Newton steps in the dip and in how the deflection is split.
std::optional<Dip> polished(Dip dip, const Pose& goal, const CurveLimits& limits) {
  const double deflection = dip.first_rad + dip.second_rad;
  const auto miss_of = [&](double q, double first) -> std::optional<Point> {
    const auto way = way_of(Dip{q, first, deflection - first}, limits);
    if (!way) return std::nullopt;
    return *way - goal.at;
  };
  const double dq = 1e-6 * limits.curvature_per_m;
  const double dfirst = 1e-6;
  for (int i = 0; i < 12; ++i) {
    const auto miss = miss_of(dip.dip_per_m, dip.first_rad);
    if (!miss) return std::nullopt;
    if (length_m(*miss) < 1e-11) return dip;
    const double back = dip.dip_per_m > dq ? -dq : dq;  // towards 0, where every dip exists
    const auto by_dip = miss_of(dip.dip_per_m + back, dip.first_rad);
    const auto by_first = miss_of(dip.dip_per_m, dip.first_rad + dfirst);
    if (!by_dip || !by_first) return std::nullopt;
    const Point a = (1 / back) * (*by_dip - *miss);
    const Point b = (1 / dfirst) * (*by_first - *miss);
    const double scale = cross(a, b);
    if (scale == 0) return std::nullopt;
    dip.dip_per_m = std::clamp(dip.dip_per_m - cross(*miss, b) / scale, 0.0, limits.curvature_per_m);
    dip.first_rad -= std::clamp(cross(a, *miss) / scale, -0.3, 0.3);
    dip.second_rad = deflection - dip.first_rad;
  }
  return std::nullopt;
}

/// The dip to the left that reaches the goal.
std::optional<Dip> dip_to(const Pose& goal, const Swings& swings) {
  const double deflection = whole_turns_off(goal.heading_rad);
  if (deflection < 1e-6 || length_m(goal.at) > 6 * length_m(swings.centre())) return std::nullopt;
  if (const auto dip = dip_between_arcs(goal, deflection, swings)) return dip;
  const auto even = even_dip(goal, deflection, swings);
  return even ? polished(*even, goal, swings.limits()) : std::nullopt;
}

void add(std::vector<Path>& paths, const Pose& from, const Pose& to, const UTurn& turn,
         const Swings& swings) {
  for (const int side : {1, -1}) {
    const Pose seen =
        side > 0 ? turn.goal : Pose{{turn.goal.at.x_m, -turn.goal.at.y_m}, -turn.goal.heading_rad};
    const auto dip = dip_to(seen, swings);
    if (!dip) continue;
    Drawn drawn{{}, from};
    draw_line(drawn, turn.before_m);
    draw_dip(drawn, *dip, side, swings.limits());
    draw_line(drawn, turn.after_m);
    offer(paths, std::move(drawn), to, swings.limits());
  }
}

}  // namespace

std::vector<Path> dip_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const Swings swings{limits};
  std::vector<Path> paths;
  add(paths, from, to, {0, 0, seen_from(from, to)}, swings);
  const auto turn = u_turn(from, to);
  if (turn && turn->before_m + turn->after_m > 0) add(paths, from, to, *turn, swings);
  return paths;
}

}  // namespace selion
