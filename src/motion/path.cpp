// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "displacement.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

double opposite(double heading_rad) {
  return heading_rad > 0 ? heading_rad - std::numbers::pi : heading_rad + std::numbers::pi;
}

Gear other(Gear gear) { return gear == Gear::forward ? Gear::reverse : Gear::forward; }

}  // namespace

CurveState state_at(const Curve& curve, double s_m) {
  const double turned_rad = (curve.curvature_per_m + curve.sharpness_per_m2 * s_m / 2) * s_m;
  return {curve.start + displacement(curve, s_m), curve.heading_rad + turned_rad,
          curve.curvature_per_m + curve.sharpness_per_m2 * s_m};
}

CurveState end_of(const Curve& curve) { return state_at(curve, curve.length_m); }

Curve line(Point a, Point b) { return {a, heading_rad(b - a), 0, 0, distance_m(a, b)}; }

Curve reversed(const Curve& curve) {
  const CurveState end = end_of(curve);
  return {end.at, opposite(end.heading_rad), -end.curvature_per_m, curve.sharpness_per_m2, curve.length_m};
}

double length_m(const Path& path) {
  double sum = 0;
  for (const Stretch& stretch : path) sum += stretch.curve.length_m;
  return sum;
}

Pose vehicle_pose(const Stretch& stretch, double s_m) {
  const CurveState state = state_at(stretch.curve, s_m);
  return {state.at, stretch.gear == Gear::forward ? state.heading_rad : opposite(state.heading_rad)};
}

Pose start_pose(const Path& path) { return vehicle_pose(path.front(), 0); }

Pose end_pose(const Stretch& stretch) {
  Pose pose = vehicle_pose(stretch, stretch.curve.length_m);
  pose.heading_rad += stretch.pivot_rad;
  return pose;
}

Pose end_pose(const Path& path) { return end_pose(path.back()); }

Path backed(const Path& path) {
  Path back;
  back.reserve(path.size());
  for (std::size_t i = path.size(); i-- > 0;) {
    Curve curve = reversed(path[i].curve);
    curve.heading_rad += path[i].pivot_rad;
    back.push_back({curve, other(path[i].gear), -path[i].pivot_rad});
  }
  return back;
}

Path turned_round(const Path& path) {
  Path out;
  out.reserve(path.size());
  for (const Stretch& stretch : path) out.push_back({reversed(stretch.curve), stretch.gear});
  std::reverse(out.begin(), out.end());
  return out;
}

void append(Path& path, const Path& more) { path.insert(path.end(), more.begin(), more.end()); }

std::vector<Pose> poses(const Path& path, double step_m) {
  std::vector<Pose> all;
  if (path.empty()) return all;
  all.push_back(start_pose(path));
  for (const Stretch& stretch : path) {
    const double length = stretch.curve.length_m;
    const int parts = std::max(1, static_cast<int>(std::ceil(length / step_m)));
    for (int i = 1; i < parts; ++i) all.push_back(vehicle_pose(stretch, length * i / parts));
    all.push_back(end_pose(stretch));
  }
  return all;
}

Gaps gaps(const Path& path) {
  Gaps largest;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Stretch& next = path[i];
    const Stretch& last = path[i - 1];
    const Pose arrived = end_pose(last);
    const Pose leaving = vehicle_pose(next, 0);
    largest.position_m = std::max(largest.position_m, distance_m(arrived.at, leaving.at));
    largest.heading_rad =
        std::max(largest.heading_rad, std::abs(wrapped(leaving.heading_rad - arrived.heading_rad)));
    if (last.gear != next.gear || is_pivot(last) || is_pivot(next)) continue;
    const double step = next.curve.curvature_per_m - end_of(last.curve).curvature_per_m;
    largest.curvature_per_m = std::max(largest.curvature_per_m, std::abs(step));
  }
  return largest;
}

}  // namespace selion
