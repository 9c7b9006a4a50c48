// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/angle.hpp"

#include <cmath>
#include <numbers>

#include "selion/core/units.hpp"

namespace selion {

double wrapped(double angle_rad) {
  const double turn = 2 * std::numbers::pi;
  if (angle_rad > -std::numbers::pi && angle_rad <= std::numbers::pi) return angle_rad;
  const double rest = std::remainder(angle_rad, turn);
  return rest <= -std::numbers::pi ? rest + turn : rest;
}

Heading Heading::radians(double anticlockwise_from_east_rad) {
  Heading heading;
  heading.radians_ = wrapped(anticlockwise_from_east_rad);
  return heading;
}

Heading Heading::bearing_deg(double clockwise_from_north_deg) {
  return radians(radians_of_degrees(90 - clockwise_from_north_deg));
}

double Heading::bearing_deg() const {
  const double bearing = std::fmod(450 - degrees_of_radians(radians_), 360.0);
  return bearing >= 360 ? 0 : bearing;
}

}  // namespace selion
