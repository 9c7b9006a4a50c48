// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace selion {

/// A place in WGS84.
struct LonLat {
  double lon_deg = 0;
  double lat_deg = 0;

  friend bool operator==(const LonLat&, const LonLat&) = default;
};

/// A place in the field's local frame: metres east (x) and north (y) of its origin. Also a displacement.
struct Point {
  double x_m = 0;
  double y_m = 0;

  friend bool operator==(const Point&, const Point&) = default;
  friend Point operator+(Point a, Point b) { return {a.x_m + b.x_m, a.y_m + b.y_m}; }
  friend Point operator-(Point a, Point b) { return {a.x_m - b.x_m, a.y_m - b.y_m}; }
  friend Point operator*(double k, Point a) { return {k * a.x_m, k * a.y_m}; }
};

inline double dot(Point a, Point b) { return a.x_m * b.x_m + a.y_m * b.y_m; }
inline double cross(Point a, Point b) { return a.x_m * b.y_m - a.y_m * b.x_m; }
/// Of places on a field nothing overflows: std::hypot, which guards against that, takes ten times as long.
inline double length_m(Point a) { return std::sqrt(a.x_m * a.x_m + a.y_m * a.y_m); }
inline double distance_m(Point a, Point b) { return length_m(b - a); }
inline Point unit(double heading_rad) { return {std::cos(heading_rad), std::sin(heading_rad)}; }
/// `a` turned by a quarter to the left.
inline Point left_of(Point a) { return {-a.y_m, a.x_m}; }
inline double heading_rad(Point a) { return std::atan2(a.y_m, a.x_m); }

/// Where the rear axle's centre is and where the vehicle points (anticlockwise from east, any turn of it).
struct Pose {
  Point at;
  double heading_rad = 0;

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// `p`, given in the frame of `pose` (x ahead, y left), in the frame that `pose` is given in.
inline Point placed(Pose pose, Point p) {
  const Point ahead = unit(pose.heading_rad);
  return pose.at + p.x_m * ahead + p.y_m * left_of(ahead);
}

}  // namespace selion
