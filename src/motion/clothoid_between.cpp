// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "direction.hpp"
#include "displacement.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/clothoid.hpp"

// Bertolazzi and Frego 2015: over a chord of 1, the heading is a (t^2 - t) + (end - start) t + start, and a
// is the root of the end's height over the chord.
namespace selion {
namespace {

/// Headings against the chord.
struct Angles {
  double start = 0;
  double end = 0;
};

/// The end of the curve of length 1, and how it moves with a.
struct Shot {
  Point end;
  Point slope;
};

/// Their fit of the root, in the paper's section 5; its error is a few hundredths.
double first_guess(const Angles& angles) {
  const double x = angles.start / std::numbers::pi;
  const double y = angles.end / std::numbers::pi;
  const double xy = x * y;
  const double squares = x * x + y * y;
  return (angles.start + angles.end) *
         (2.989696028701907 + xy * (0.716228953608281 - 0.458969738821509 * xy) +
          (-0.502821153340377 + 0.261062141752652 * xy) * squares - 0.045854475238709 * squares * squares);
}

Point end_at(const Angles& angles, double a, const EndDirections& ways) {
  return displacement({{}, angles.start, angles.end - angles.start - a, 2 * a, 1}, 1, ways);
}

/// i times the integral of (t^2 - t) exp(i heading), by parts from the integral of exp(i heading), which is
/// `end`.
Point slope_at(double a, double turn, Point end, const EndDirections& ways) {
  const auto [first, last] = ways;
  const double k = turn - a;
  const double c = 2 * a;
  // A division by i turns right.
  const Point rise = {last.y_m - first.y_m, first.x_m - last.x_m};
  const Point once = (1 / c) * (rise - k * end);
  const Point twice = (1 / c) * (Point{last.y_m - end.y_m, end.x_m - last.x_m} - k * once);
  return left_of(twice - once);
}

Shot shoot(const Angles& angles, double a, const EndDirections& ways) {
  // The integration by parts divides by a^2; so near 0 the slope a little farther does.
  constexpr double kLeast = 5e-4;
  const double turn = angles.end - angles.start;
  const Point end = end_at(angles, a, ways);
  if (std::abs(a) >= kLeast) return {end, slope_at(a, turn, end, ways)};
  return {end, slope_at(kLeast, turn, end_at(angles, kLeast, ways), ways)};
}

}  // namespace

Curve clothoid_between(const Pose& from, const Pose& to) {
  // Newton's error is a share of the step's square, and the more of it the farther the curve goes round.
  constexpr double kSmall = 1e-16;
  const Point chord = to.at - from.at;
  const double along = heading_rad(chord);
  const Angles angles{wrapped(from.heading_rad - along), wrapped(to.heading_rad - along)};
  const EndDirections ways{direction({angles.start, 0}), direction({angles.end, 0})};
  double a = first_guess(angles);
  double reach = 1;
  for (int i = 0; i < 30; ++i) {
    const Shot shot = shoot(angles, a, ways);
    const double step = -shot.end.y_m / shot.slope.y_m;
    a += step;
    reach = shot.end.x_m + step * shot.slope.x_m;
    if (step * step < kSmall * std::abs(reach)) break;
  }
  const double length = length_m(chord) / reach;
  if (length == 0) return {from.at, from.heading_rad, 0, 0, 0};
  const double turn = angles.end - angles.start;
  return {from.at, from.heading_rad, (turn - a) / length, 2 * a / (length * length), length};
}

}  // namespace selion
