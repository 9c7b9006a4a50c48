// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/core/point.hpp"

namespace selion {

/// A line, arc or clothoid: curvature grows by `sharpness_per_m2` for every metre of travel. Left is
/// positive. `heading_rad` is the direction of travel at the start (in reverse gear the vehicle points the
/// other way).
struct Curve {
  Point start;
  double heading_rad = 0;
  double curvature_per_m = 0;
  double sharpness_per_m2 = 0;
  double length_m = 0;

  friend bool operator==(const Curve&, const Curve&) = default;
};

inline bool is_straight(const Curve& curve) {
  return curve.curvature_per_m == 0 && curve.sharpness_per_m2 == 0;
}

struct CurveState {
  Point at;
  double heading_rad = 0;  ///< continuous along the curve, not wrapped
  double curvature_per_m = 0;
};

/// Exact to 1e-15 of the way driven and of the numbers given; `s_m` may lie outside [0, length].
CurveState state_at(const Curve& curve, double s_m);
CurveState end_of(const Curve& curve);
/// @pre a != b.
Curve line(Point a, Point b);
/// Driven from its end to its start.
Curve reversed(const Curve& curve);

enum class Gear { forward = 1, reverse = -1 };

/// A curve driven in one gear. Or a pivot, where `pivot_rad` is not 0: the machine stands and rotates by so
/// much, left positive, about the start of a curve of length 0, which has the heading before it.
struct Stretch {
  Curve curve;
  Gear gear = Gear::forward;
  double pivot_rad = 0;

  friend bool operator==(const Stretch&, const Stretch&) = default;
};

inline bool is_pivot(const Stretch& stretch) { return stretch.pivot_rad != 0; }

/// Stretches end to end: position, vehicle heading and, but for pivots and cusps where the gear changes,
/// curvature are continuous.
using Path = std::vector<Stretch>;

double length_m(const Path& path);
/// Of the vehicle, at the start and the end. @pre the path is not empty.
Pose start_pose(const Path& path);
Pose end_pose(const Path& path);
/// Of a pivot: before it.
Pose vehicle_pose(const Stretch& stretch, double s_m);
Pose end_pose(const Stretch& stretch);
/// The same ground driven the other way in the other gear.
Path backed(const Path& path);
/// The same line from its end to its start, in the same gears. @pre no pivots.
Path turned_round(const Path& path);
void append(Path& path, const Path& more);

/// Vehicle poses from start to end, at both ends of every stretch and at most `step_m` apart: of a pivot
/// before and after it.
std::vector<Pose> poses(const Path& path, double step_m);

/// Largest of the gaps between consecutive stretches: metres, radians (vehicle heading), 1/m (cusps and
/// pivots left out).
struct Gaps {
  double position_m = 0;
  double heading_rad = 0;
  double curvature_per_m = 0;
};
Gaps gaps(const Path& path);

}  // namespace selion
