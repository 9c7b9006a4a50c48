// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace selion {
namespace {

/// A clothoid from the peak curvature (the first of the steps) down to 0, or up to it.
struct Step {
  double from_per_m = 0;
  double to_per_m = 0;
  double length_m = 0;
  bool is_sharpest = false;  ///< as short as the sharpness allows, so its length grows with the peak

  [[nodiscard]] double turn_rad() const { return (from_per_m + to_per_m) / 2 * length_m; }
};

constexpr std::size_t kMostSteps = 4;
struct Flank {
  std::array<Step, kMostSteps> steps;
  std::size_t count = 0;

  [[nodiscard]] double turn_rad() const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += steps[i].turn_rad();
    return sum;
  }
  /// Of the turn, over the peak's relative growth.
  [[nodiscard]] double growth_rad() const {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += (steps[i].is_sharpest ? 2 : 1) * steps[i].turn_rad();
    return sum;
  }
};

/// From the peak to straight: halved and halved again in equal lengths, as exp(-s / ease_m) is, to an eighth,
/// which the last step takes to 0 by the same turn as the exponential's whole rest.
Flank flank(double peak_per_m, double ease_m, double sharpness_per_m2) {
  const auto step = [&](double from, double to, double wish_m) {
    const double shortest_m = (from - to) / sharpness_per_m2;
    return Step{from, to, std::max(wish_m, shortest_m), wish_m < shortest_m};
  };
  if (ease_m <= 0) return {{step(peak_per_m, 0, 0)}, 1};
  Flank flank;
  double k = peak_per_m;
  for (; flank.count + 1 < kMostSteps; k /= 2)
    flank.steps[flank.count++] = step(k, k / 2, ease_m * std::numbers::ln2);
  flank.steps[flank.count++] = step(k, 0, 2 * ease_m);
  return flank;
}

struct Corner3 {
  Flank in;
  double peak_per_m = 0;
  double arc_m = 0;
  Flank out;
};

/// @pre turn_rad > 0.
Corner3 corner_of_turn(double turn_rad, const CornerShape& shape) {
  const auto at_peak = [&](double k) {
    return Corner3{flank(k, shape.ease_in_m, shape.limits.sharpness_per_m2), k, 0,
                   flank(k, shape.ease_out_m, shape.limits.sharpness_per_m2)};
  };
  constexpr double kExact = 1e-14;  // of the turn
  constexpr int kMostTries = 60;
  const auto rest_of = [&](const Corner3& c) { return turn_rad - c.in.turn_rad() - c.out.turn_rad(); };
  Corner3 corner = at_peak(shape.limits.curvature_per_m);
  double rest = rest_of(corner);
  // Where the limit is not reached: the peak at which the flanks turn by just that much, by Newton's steps
  // from above, where what they turn is convex.
  for (int i = 0; i < kMostTries && rest < -kExact * turn_rad; ++i) {
    corner = at_peak(corner.peak_per_m * (1 + rest / (corner.in.growth_rad() + corner.out.growth_rad())));
    rest = rest_of(corner);
  }
  corner.arc_m = std::max(rest, 0.0) / corner.peak_per_m;
  return corner;
}

void add(Path& path, Pose& at, double k, double k_end, double length_m) {
  const Curve curve{at.at, at.heading_rad, k, (k_end - k) / length_m, length_m};
  const CurveState end = end_of(curve);
  path.push_back({curve, Gear::forward});
  at = {end.at, end.heading_rad};
}

}  // namespace

Path corner_path(const Pose& start, double turn_rad, const CornerShape& shape) {
  if (shape.ease_in_m <= 0 && shape.ease_out_m <= 0) return swing(start, turn_rad, shape.limits);
  constexpr double kNoArc_m = 1e-6;
  const double side = turn_rad > 0 ? 1 : -1;
  const Corner3 corner = corner_of_turn(std::abs(turn_rad), shape);
  Path path;
  Pose at = start;
  for (std::size_t i = corner.in.count; i-- > 0;) {
    const Step& step = corner.in.steps[i];
    add(path, at, side * step.to_per_m, side * step.from_per_m, step.length_m);
  }
  if (corner.arc_m > kNoArc_m)
    add(path, at, side * corner.peak_per_m, side * corner.peak_per_m, corner.arc_m);
  for (std::size_t i = 0; i < corner.out.count; ++i) {
    const Step& step = corner.out.steps[i];
    add(path, at, side * step.from_per_m, side * step.to_per_m, step.length_m);
  }
  return path;
}

CornerReach reach_of(double turn_rad, const CornerShape& shape) {
  if (shape.ease_in_m <= 0 && shape.ease_out_m <= 0) {
    const Corner corner = corner_of(turn_rad, shape.limits);
    return {corner.tangent_m, corner.tangent_m, corner.cut_m};
  }
  const double turn = std::abs(turn_rad);
  const Path path = corner_path({}, turn, shape);
  const Point end = end_pose(path).at;
  const double after = end.y_m / std::sin(turn);
  const Point meet{end.x_m - after * std::cos(turn), 0};
  double cut = meet.x_m;
  for (const Pose& pose : poses(path, meet.x_m / 16)) cut = std::min(cut, distance_m(pose.at, meet));
  return {meet.x_m, after, cut};
}

namespace {

/// How far body and tool reach beyond the lane's right edge, along the line before and along the line after.
struct SwingOut {
  double before_m = 0;
  double after_m = 0;
};

/// Not looked at further where it is more than `most`.
SwingOut swing_out_of(const Path& path, const Footprint& f, const SwingOut& most) {
  constexpr double kStep_m = 0.3;
  const double half = std::max(f.half_body_m, f.half_tool_m);
  const std::array corners{Point{f.front_m, -f.half_body_m}, Point{f.front_m, f.half_body_m},
                           Point{-f.rear_m, -f.half_body_m}, Point{f.tool_x_m, -f.half_tool_m}};
  const Pose last = end_pose(path);
  const Point right = -1 * left_of(unit(last.heading_rad));
  SwingOut out;
  for (const Pose& pose : poses(path, kStep_m)) {
    const Point ahead = unit(pose.heading_rad);
    for (const Point corner : corners) {
      const Point p = pose.at + corner.x_m * ahead + corner.y_m * left_of(ahead);
      out.before_m = std::max(out.before_m, -p.y_m - half);
      out.after_m = std::max(out.after_m, dot(p - last.at, right) - half);
    }
    if (out.before_m > most.before_m || out.after_m > most.after_m) break;
  }
  return out;
}

/// The least ease that keeps the swing within the room; the most tried where none does.
template <class SwingOf>
double least_ease_m(double most_m, double room_m, SwingOf swing_of) {
  constexpr int kHalvings = 7;
  double low = 0;
  double high = most_m;
  for (int i = 0; i < kHalvings; ++i) {
    const double ease = (low + high) / 2;
    (swing_of(ease) > room_m ? low : high) = ease;
  }
  return high;
}

}  // namespace

CornerShape shape_within(double turn_rad, const CurveLimits& limits, const Footprint& footprint,
                         double room_m) {
  CornerShape shape{limits, 0, 0};
  const double reach = reach_m(footprint);
  if (turn_rad <= 0 || reach * turn_rad <= room_m) return shape;  // even the farthest corner stays within
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const auto swing = [&](const CornerShape& s, const SwingOut& most) {
    return swing_out_of(corner_path({}, turn_rad, s), footprint, most);
  };
  const SwingOut plain = swing(shape, {kAny, kAny});
  const double most_m = 3 * reach;
  if (plain.after_m > room_m)
    shape.ease_out_m = least_ease_m(most_m, room_m, [&](double ease) {
      return swing({limits, 0, ease}, {kAny, room_m}).after_m;
    });
  if (plain.before_m > room_m)
    shape.ease_in_m = least_ease_m(most_m, room_m, [&](double ease) {
      return swing({limits, ease, shape.ease_out_m}, {room_m, kAny}).before_m;
    });
  return shape;
}

}  // namespace selion
