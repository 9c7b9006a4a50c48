// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/path.hpp"
#include "selion/motion/swings.hpp"

namespace selion {

/// `p` turned by the angle whose unit vector is `by`.
inline Point turned(Point by, Point p) {
  return {by.x_m * p.x_m - by.y_m * p.y_m, by.x_m * p.y_m + by.y_m * p.x_m};
}
inline Point mirrored(Point p) { return {p.x_m, -p.y_m}; }
inline Pose mirrored(const Pose& pose) { return {mirrored(pose.at), -pose.heading_rad}; }

/// By how much a swing turns, left positive, and which way its chord leads.
struct Deflection {
  double rad = 0;
  Point half{1, 0};  ///< unit(rad / 2)
};
inline Deflection deflection(double rad) { return {rad, unit(rad / 2)}; }

/// A path while it is drawn, curve by curve, and where it has come to.
struct Drawn {
  explicit Drawn(const Pose& from) : Drawn{from, unit(from.heading_rad)} {}
  Drawn(const Pose& from, Point ahead_of_from) : at{from}, ahead{ahead_of_from} { path.reserve(11); }

  Path path;
  Pose at;
  Point ahead;  ///< unit(at.heading_rad)
};
/// Nothing where `length_m` is not above 0.
void draw_line(Drawn& drawn, double length_m);
void draw_line_back(Drawn& drawn, double length_m);
/// `turn` is the unit vector of the arc's deflection.
void draw_arc(Drawn& drawn, double curvature_per_m, double length_m, Point turn);
void draw_arc(Drawn& drawn, double curvature_per_m, double length_m);
void draw_arc_back(Drawn& drawn, double curvature_per_m, double length_m);
/// A clothoid whose end, as displacement in the frame of its start, and deflection's unit vector are known.
struct Ramp {
  double curvature_per_m = 0;
  double sharpness_per_m2 = 0;
  double length_m = 0;
  Point way;
  Point turn;
};
void draw_ramp(Drawn& drawn, const Ramp& ramp);
/// A rotation on the spot; nothing where `angle_rad` is 0.
void draw_pivot(Drawn& drawn, double angle_rad);
/// Nothing where the deflection is 0.
void draw_swing(Drawn& drawn, const Deflection& by, const Swings& swings);

}  // namespace selion
