// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/dubins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "offer.hpp"

namespace selion {
namespace {

constexpr double kOneCircle = 1e-12;  // radii between two circles that are one but for rounding

/// Whole turns off; rounding below 0 is no whole turn.
double turned(double angle_rad) {
  constexpr double kRounding_rad = 1e-9;
  const double rest = whole_turns_off(angle_rad);
  return rest > 2 * std::numbers::pi - kRounding_rad ? 0 : rest;
}

/// Start at the origin, goal at distance d (in radii) ahead on the x axis; headings alpha and beta from it.
struct Setting {
  double d;
  double alpha;
  double beta;
  double sin_alpha;
  double cos_alpha;
  double sin_beta;
  double cos_beta;
};

/// Turns to the same side with a straight between them.
double same_sides(const Setting& at, double side) {
  const double ahead = at.d + side * (at.sin_alpha - at.sin_beta);
  const double across = side * (at.cos_beta - at.cos_alpha);
  const double straight = length_m({ahead, across});
  if (straight < kOneCircle) return turned(side * (at.beta - at.alpha));
  const double bearing = std::atan2(across, ahead);
  return turned(side * (bearing - at.alpha)) + straight + turned(side * (at.beta - bearing));
}

/// A turn to `side`, a straight, a turn to the other side.
double other_sides(const Setting& at, double side) {
  const double ahead = at.d + side * (at.sin_alpha + at.sin_beta);
  const double across = -side * (at.cos_alpha + at.cos_beta);
  const double square = ahead * ahead + across * across - 4;
  if (square < 0) return std::numeric_limits<double>::infinity();
  const double straight = std::sqrt(square);
  const double bearing = std::atan2(across, ahead) + side * std::atan2(2, straight);
  return turned(side * (bearing - at.alpha)) + straight + turned(side * (bearing - at.beta));
}

/// Three turns, the middle one to the other side and longer than half a turn.
double three_turns(const Setting& at, double side) {
  const double ahead = at.d + side * (at.sin_alpha - at.sin_beta);
  const double across = side * (at.cos_beta - at.cos_alpha);
  const double half = length_m({ahead, across}) / 4;
  if (half > 1) return std::numeric_limits<double>::infinity();
  const double middle = 2 * std::numbers::pi - 2 * std::asin(half);
  const double first = turned(side * (std::atan2(across, ahead) - at.alpha) + middle / 2);
  return first + middle + turned(side * (at.beta - at.alpha) - first + middle);
}

}  // namespace

double dubins_length_m(const Pose& from, const Pose& to, double radius_m) {
  const Point way = to.at - from.at;
  const double bearing = length_m(way) > 0 ? std::atan2(way.y_m, way.x_m) : 0;
  const double alpha = from.heading_rad - bearing;
  const double beta = to.heading_rad - bearing;
  const Setting at{length_m(way) / radius_m, alpha,          beta,          std::sin(alpha),
                   std::cos(alpha),          std::sin(beta), std::cos(beta)};
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {1.0, -1.0})
    least = std::min({least, same_sides(at, side), other_sides(at, side), three_turns(at, side)});
  return radius_m * least;
}

}  // namespace selion
