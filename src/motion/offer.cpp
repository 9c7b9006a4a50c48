// SPDX-License-Identifier: GPL-3.0-or-later
#include "offer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr double kMeets = 1e-9;         // m, rad, 1/m
constexpr double kAntiparallel = 1e-6;  // rad
constexpr double kRounding_rad = 4e-15;

bool keeps(const Path& path, const CurveLimits& limits) {
  return std::all_of(path.begin(), path.end(), [&limits](const Stretch& stretch) {
    const Curve& curve = stretch.curve;
    const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
    return std::max(std::abs(curve.curvature_per_m), std::abs(end)) <=
               limits.curvature_per_m * (1 + kMeets) &&
           std::abs(curve.sharpness_per_m2) <= limits.sharpness_per_m2 * (1 + kMeets) && curve.length_m >= 0;
  });
}

}  // namespace

View::View(const Pose& from_pose, const Pose& to_pose)
    : from{from_pose}, to{to_pose}, ahead{unit(from_pose.heading_rad)} {
  const Point way = to.at - from.at;
  goal = {{dot(ahead, way), cross(ahead, way)}, wrapped(to.heading_rad - from.heading_rad)};
}

double whole_turns_off(double angle_rad) {
  const double turn = 2 * std::numbers::pi;
  if (angle_rad >= 0 && angle_rad < turn) return angle_rad;
  const double rest = angle_rad - turn * std::floor(angle_rad / turn);
  return rest >= turn || rest < 0 ? 0 : rest;
}

std::optional<Path> drawn_to(const Word& word, const View& view, const Swings& swings) {
  Drawn drawn{view.from, view.ahead};
  draw_word(drawn, word, swings);
  const Point off = view.to.at - drawn.at.at;
  const bool meets = dot(off, off) <= kMeets * kMeets &&
                     std::abs(wrapped(drawn.at.heading_rad - view.to.heading_rad)) <= kMeets;
  if (!meets || !keeps(drawn.path, swings.limits())) return std::nullopt;
  return std::move(drawn.path);
}

std::optional<UTurn> u_turn(Pose goal) {
  const double off_rad = std::numbers::pi - std::abs(goal.heading_rad);
  if (off_rad > kAntiparallel) return std::nullopt;
  UTurn turn;
  turn.opposite = off_rad < kRounding_rad;
  if (goal.at.x_m > 0) {
    turn.before_m = goal.at.x_m;
    goal.at.x_m = 0;
  } else {
    // Driven at the goal's heading, so that the turn's end lies straight behind the goal.
    const Point along = turn.opposite ? Point{-1, 0} : unit(goal.heading_rad);
    turn.after_m = goal.at.x_m / along.x_m;
    goal.at = goal.at - turn.after_m * along;
  }
  turn.goal = goal;
  return turn;
}

}  // namespace selion
