// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_ways.hpp"

#include <algorithm>
#include <cmath>

#include "selion/motion/dead_ends.hpp"

namespace selion {
namespace {

/// The longest way up to `most_m` that holds, to a centimetre; 0 where there is none.
template <class Holds>
double longest_m(double most_m, Holds holds) {
  constexpr double kExact_m = 0.01;
  if (most_m <= 0) return 0;
  if (holds(most_m)) return most_m;
  double low = 0;
  for (double high = most_m; high - low > kExact_m;) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// Shorter until the place can be left, or come to.
template <class Passes>
double passable_m(const Ground& ground, double by_m, Passes passes) {
  constexpr double kStep_m = 0.25;
  if (ground.machine.may_reverse) return by_m;
  while (by_m > 0 && !passes(by_m)) by_m -= kStep_m;
  return std::max(by_m, 0.0);
}

/// From the corner on to that of both lanes' outer edges: beyond it the tool finds nothing more.
double beyond_m(const Ground& ground, const LeftTurn& turn) {
  return ground.half_m * std::tan(turn.turn_rad / 2);
}

/// The shortest turn forwards.
std::optional<Path> turn_ahead(const Ground& ground, const Pose& from, const Pose& to) {
  const double longest_m = 14 / ground.swings.limits().curvature_per_m + 6 * ground.half_m;
  Connections turns{from, to, ground.swings};
  while (auto way = turns.next(longest_m))
    if (stays_inside(ground.space, ground.footprint, *way)) return way;
  return std::nullopt;
}

/// Along the side before the bend to a curve, round it, and along the next side to its begin.
Path by_curve(const Pose& from, double to_curve_m, const Path& curve, double to_begin_m) {
  Path way = straight(from, to_curve_m);
  append(way, curve);
  append(way, straight(end_pose(curve), to_begin_m));
  return way;
}

}  // namespace

bool is_corner(const Ground& ground, const LeftTurn& turn) {
  constexpr double kWidest = 3;  // times the tightest turn: more than a long body needs to swing clear
  CurveLimits working = ground.swings.limits();
  if (const auto radius_m = ground.machine.min_work_radius_m)
    working.curvature_per_m = std::min(working.curvature_per_m, 1 / *radius_m);
  const double most_m = kWidest * corner_of(turn.turn_rad, working).tangent_m;
  return std::max(turn.before_m, turn.after_m) <= most_m;
}

double farthest_on_m(const Ground& ground, const LeftTurn& turn) {
  const double most_m = turn.before_m + beyond_m(ground, turn) - ground.machine.tool_x_m;
  const double by_m = longest_m(
      most_m, [&](double m) { return stays_inside(ground.space, ground.footprint, straight(turn.in, m)); });
  return passable_m(ground, by_m, [&](double m) {
    return has_way_out(ground.space, ground.footprint, ground.swings, on_from(turn.in, m));
  });
}

double farthest_back_m(const Ground& ground, const LeftTurn& turn) {
  const double most_m = turn.after_m + beyond_m(ground, turn) + ground.machine.tool_x_m;
  const double by_m = longest_m(most_m, [&](double m) {
    return stays_inside(ground.space, ground.footprint, straight(on_from(turn.out, -m), m));
  });
  return passable_m(ground, by_m, [&](double m) {
    return has_way_in(ground.space, ground.footprint, ground.swings, on_from(turn.out, -m));
  });
}

std::optional<Path> way_round(const Ground& ground, const LeftTurn& turn, const Path& bend, const Fill& fill,
                              const Sides& sides) {
  const Pose from = on_from(turn.in, fill.on_m);
  if (!ground.machine.may_reverse) return turn_ahead(ground, from, on_from(turn.out, -fill.back_m));
  // with the tool up it may turn more tightly than the bend
  const double tangent_m = corner_of(turn.turn_rad, ground.swings.limits()).tangent_m;
  const double curve_on_m = turn.before_m - tangent_m;
  const double curve_end_m = tangent_m - turn.after_m;
  if (curve_on_m > -sides.before_m && curve_end_m < sides.after_m) {
    const Path tight = swing(on_from(turn.in, curve_on_m), turn.turn_rad, ground.swings);
    Path way = by_curve(from, curve_on_m - fill.on_m, tight, -fill.back_m - curve_end_m);
    if (stays_inside(ground.space, ground.footprint, way)) return way;
  }
  return by_curve(from, -fill.on_m, bend, -fill.back_m);
}

}  // namespace selion
