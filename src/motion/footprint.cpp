// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/footprint.hpp"

#include <algorithm>
#include <cmath>

namespace selion {
namespace {

constexpr double kGive_m =
    0.004;  // of the centimetre that "inside" allows; rounding of headland rings takes the rest
constexpr double kCurveStep_m =
    0.15;  // a corner of the body strays less than 3 mm from the chord between two checks
constexpr double kLineStep_m = 8;
constexpr double kSweepStep_m = 0.25;

bool straight(const Curve& curve) { return curve.curvature_per_m == 0 && curve.sharpness_per_m2 == 0; }

/// The rectangle from x = rear to x = front, `half` to either side, in the frame of `pose`.
std::vector<Point> rectangle(const Pose& pose, double rear_m, double front_m, double half_m) {
  return {placed(pose, {rear_m, -half_m}), placed(pose, {front_m, -half_m}), placed(pose, {front_m, half_m}),
          placed(pose, {rear_m, half_m})};
}

/// Body and tool while the vehicle moves straight from `ahead_m` = 0 to `ahead_m` (negative: backwards).
bool clear_on_line(const FreeSpace& space, const Footprint& f, const Pose& pose, double ahead_m) {
  const double back = std::min(ahead_m, 0.0);
  const double fore = std::max(ahead_m, 0.0);
  return space.clear(rectangle(pose, -f.rear_m + kGive_m + back, f.front_m - kGive_m + fore,
                               f.half_body_m - kGive_m)) &&
         space.clear(rectangle(pose, f.tool_x_m - kGive_m + back, f.tool_x_m + kGive_m + fore,
                               f.half_tool_m - kGive_m));
}

bool clear_at(const FreeSpace& space, const Footprint& f, const Pose& pose) {
  return space.far_from_border(pose.at) || clear_on_line(space, f, pose, 0);
}

/// Nothing near at the start, the middle and the end: with the slack of `free_space` that is nothing near
/// between them.
bool far_along(const FreeSpace& space, const Pose& pose, double ahead_m) {
  const Point step = (ahead_m / 2) * unit(pose.heading_rad);
  return space.far_from_border(pose.at) && space.far_from_border(pose.at + step) &&
         space.far_from_border(pose.at + 2 * step);
}

bool clear_along(const FreeSpace& space, const Footprint& f, const Stretch& stretch) {
  const double length = stretch.curve.length_m;
  const double step = straight(stretch.curve) ? kLineStep_m : kCurveStep_m;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  for (int i = 0; i < steps; ++i) {
    const Pose pose = vehicle_pose(stretch, length * i / steps);
    if (straight(stretch.curve)) {
      const double ahead = length / steps * static_cast<int>(stretch.gear);
      if (far_along(space, pose, ahead)) continue;
      if (!clear_on_line(space, f, pose, ahead)) return false;
    } else if (!clear_at(space, f, pose)) {
      return false;
    }
  }
  return clear_at(space, f, vehicle_pose(stretch, length));
}

/// Convex hull of four points (a quad whose inner end turned back crosses itself).
Ring hull_of(Ring points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x_m < b.x_m || (a.x_m == b.x_m && a.y_m < b.y_m); });
  Ring hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t floor = hull.size() + 1;
    for (const Point p : points) {
      while (hull.size() > floor && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

Footprint footprint_of(const Machine& machine) {
  return {machine.front_m, machine.rear_m, machine.body_width_m / 2, machine.tool_x_m,
          machine.working_width_m / 2};
}

double reach_m(const Footprint& f) {
  return std::max(std::hypot(std::max(f.front_m, f.rear_m), f.half_body_m),
                  std::hypot(f.tool_x_m, f.half_tool_m));
}

FreeSpace free_space(const Polygon& area, const Footprint& footprint) {
  return {area, reach_m(footprint) + kLineStep_m / 4};
}

bool stays_inside(const FreeSpace& space, const Footprint& footprint, const Path& path) {
  return std::all_of(path.begin(), path.end(),
                     [&](const Stretch& s) { return clear_along(space, footprint, s); });
}

bool fits(const FreeSpace& space, const Footprint& footprint, const Pose& pose) {
  return space.holds(pose.at) && clear_on_line(space, footprint, pose, 0);
}

bool fits(const FreeSpace& space, const Footprint& footprint, const Path& path) {
  return path.empty() || (space.holds(path.front().curve.start) && stays_inside(space, footprint, path));
}

std::vector<Ring> swept_by_tool(const Footprint& f, const Path& path) {
  std::vector<Ring> swept;
  for (const Stretch& stretch : path) {
    const double length = stretch.curve.length_m;
    const int steps =
        straight(stretch.curve) ? 1 : std::max(1, static_cast<int>(std::ceil(length / kSweepStep_m)));
    Pose before = vehicle_pose(stretch, 0);
    for (int i = 1; i <= steps; ++i) {
      const Pose after = vehicle_pose(stretch, length * i / steps);
      swept.push_back(
          hull_of({placed(before, {f.tool_x_m, -f.half_tool_m}), placed(after, {f.tool_x_m, -f.half_tool_m}),
                   placed(after, {f.tool_x_m, f.half_tool_m}), placed(before, {f.tool_x_m, f.half_tool_m})}));
      before = after;
    }
  }
  return swept;
}

}  // namespace selion
