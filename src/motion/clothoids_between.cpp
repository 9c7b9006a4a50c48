// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "displacement.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/clothoid.hpp"

// Bertolazzi and Frego 2018: the outer two clothoids get a length, the middle one's length and the curvatures
// at the joints follow. With outer lengths that tend to 0 the three tend to the single clothoid of the two
// poses, whatever the curvatures at the ends: so shorter and shorter ones are tried, each by Newton's method.
namespace selion {
namespace {

using Three = std::array<Curve, 3>;

/// Over the chord from (0, 0) to (1, 0).
struct Task {
  double start_rad = 0;
  double turn_rad = 0;
  double start_curvature = 0;
  double end_curvature = 0;
  double first_m = 0;  ///< length of the first clothoid
  double last_m = 0;
};

struct Unknowns {
  double joint_curvature = 0;  ///< of the first and the middle clothoid
  double middle_m = 0;
};

Curve bent(double from, double to, double length) { return {{}, 0, from, (to - from) / length, length}; }

/// What turns by the task's angle in all: the mean curvatures times the lengths add up to it.
Three drawn(const Task& task, const Unknowns& unknowns) {
  const auto [joint, middle] = unknowns;
  const double rest = 2 * task.turn_rad - task.first_m * task.start_curvature -
                      task.last_m * task.end_curvature - joint * (task.first_m + middle);
  const double second = rest / (middle + task.last_m);
  Three three{bent(task.start_curvature, joint, task.first_m), bent(joint, second, middle),
              bent(second, task.end_curvature, task.last_m)};
  three[0].heading_rad = task.start_rad;
  for (std::size_t i = 1; i < 3; ++i) {
    const CurveState end = end_of(three[i - 1]);
    three[i].start = end.at;
    three[i].heading_rad = end.heading_rad;
  }
  return three;
}

Point miss(const Task& task, const Unknowns& unknowns) {
  return end_of(drawn(task, unknowns)[2]).at - Point{1, 0};
}

Unknowns moved(const Unknowns& from, double share, const Unknowns& step) {
  return {from.joint_curvature + share * step.joint_curvature, from.middle_m + share * step.middle_m};
}

/// Newton's step; the slopes are differences.
Unknowns newton_step(const Task& task, const Unknowns& at, Point now) {
  const double curvature_step = 1e-7 * (1 + std::abs(at.joint_curvature));
  const double length_step = 1e-7 * at.middle_m;
  const Point by_curvature = 1 / curvature_step * (miss(task, moved(at, 1, {curvature_step, 0})) - now);
  const Point by_length = 1 / length_step * (miss(task, moved(at, 1, {0, length_step})) - now);
  const double size = cross(by_curvature, by_length);
  return {-cross(now, by_length) / size, -cross(by_curvature, now) / size};
}

/// Half the step, and half again, until it leads nearer.
std::optional<Unknowns> nearer(const Task& task, const Unknowns& at, const Unknowns& step, double distance) {
  double share = 1;
  for (int i = 0; i < 10; ++i, share /= 2) {
    const Unknowns next = moved(at, share, step);
    if (next.middle_m > 0 && length_m(miss(task, next)) < distance) return next;
  }
  return std::nullopt;
}

std::optional<Three> solved(const Task& task, Unknowns at) {
  // The first ends the search, the second is what must be reached.
  constexpr double kEnough = 2e-15;
  constexpr double kMet = 1e-12;
  for (int i = 0; i < 30; ++i) {
    const Point now = miss(task, at);
    if (length_m(now) < kEnough) break;
    const auto next = nearer(task, at, newton_step(task, at, now), length_m(now));
    if (!next) break;
    at = *next;
  }
  const double scale = 1 + task.first_m + at.middle_m + task.last_m;
  if (length_m(miss(task, at)) > kMet * scale) return std::nullopt;
  return drawn(task, at);
}

/// At most a third of the whole; and what it turns apart from the single clothoid stays small.
double outer_length(double wanted, double single, double whole) {
  constexpr double kMostApart_rad = std::numbers::pi / 8;
  const double apart = std::abs(wanted - single);
  return std::min(whole / 3, apart > 0 ? 2 * kMostApart_rad / apart : whole);
}

/// In the field's frame again.
Three placed(Three three, const Pose& from, double turned_by, double scale) {
  for (std::size_t i = 0; i < 3; ++i) {
    Curve& curve = three[i];
    curve = {from.at, curve.heading_rad + turned_by, curve.curvature_per_m / scale,
             curve.sharpness_per_m2 / (scale * scale), curve.length_m * scale};
    if (i == 0) curve.heading_rad = from.heading_rad;
    if (i > 0) curve.start = end_of(three[i - 1]).at;
  }
  return three;
}

}  // namespace

std::optional<Three> clothoids_between(const BentPose& from, const BentPose& to) {
  constexpr int kHalvings = 14;
  const Point chord = to.pose.at - from.pose.at;
  const double scale = length_m(chord);
  if (scale == 0) return std::nullopt;
  const double along = heading_rad(chord);
  const double start = wrapped(from.pose.heading_rad - along);
  const double end = wrapped(to.pose.heading_rad - along);
  const Curve single = clothoid_between({{}, start}, {{1, 0}, end});
  Task task{start, end - start, from.curvature_per_m * scale, to.curvature_per_m * scale, 0, 0};
  const double end_curvature = end_of(single).curvature_per_m;
  const double first = outer_length(task.start_curvature, single.curvature_per_m, single.length_m);
  const double last = outer_length(task.end_curvature, end_curvature, single.length_m);
  for (int i = 0; i < kHalvings; ++i) {
    task.first_m = std::ldexp(first, -i);
    task.last_m = std::ldexp(last, -i);
    const Unknowns guess{single.curvature_per_m + single.sharpness_per_m2 * task.first_m,
                         single.length_m - task.first_m - task.last_m};
    if (const auto three = solved(task, guess)) return placed(*three, from.pose, along, scale);
  }
  return std::nullopt;
}

CurveLimits largest_bend(const Path& path) {
  CurveLimits largest;
  for (const Stretch& stretch : path) {
    const Curve& curve = stretch.curve;
    const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
    largest.curvature_per_m =
        std::max({largest.curvature_per_m, std::abs(curve.curvature_per_m), std::abs(end)});
    largest.sharpness_per_m2 = std::max(largest.sharpness_per_m2, std::abs(curve.sharpness_per_m2));
  }
  return largest;
}

bool keeps(const Path& path, const CurveLimits& limits) {
  constexpr double kRounding = 1 + 1e-9;
  const CurveLimits largest = largest_bend(path);
  return largest.curvature_per_m <= kRounding * limits.curvature_per_m &&
         largest.sharpness_per_m2 <= kRounding * limits.sharpness_per_m2;
}

}  // namespace selion
