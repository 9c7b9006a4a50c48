// SPDX-License-Identifier: GPL-3.0-or-later
#include "quantity.hpp"

#include <cmath>

#include "selion/core/format.hpp"
#include "selion/core/units.hpp"

namespace selion {
namespace {

constexpr double kFeetPerMile = 5280;

}  // namespace

std::string area_text(double area_m2, Units units) {
  const bool metric = units == Units::metric;
  const double large = metric ? hectares_of_m2(area_m2) : acres_of_m2(area_m2);
  if (large == 0 || large >= 0.01) return fixed(large, 2) + (metric ? " ha" : " ac");
  return metric ? fixed(area_m2, 0) + " m\u00B2" : fixed(feet_of_m(feet_of_m(area_m2)), 0) + " ft\u00B2";
}

std::string length_text(double length_m, int decimals, Units units) {
  return units == Units::metric ? fixed(length_m, decimals) + " m"
                                : fixed(feet_of_m(length_m), decimals) + " ft";
}

std::string distance_text(double distance_m, Units units) {
  const bool metric = units == Units::metric;
  const double large = metric ? distance_m / 1000 : feet_of_m(distance_m) / kFeetPerMile;
  if (large >= 1) return fixed(large, 1) + (metric ? " km" : " mi");
  return length_text(distance_m, 0, units);
}

std::string time_text(double time_s) {
  if (time_s < 59.5) return fixed(time_s, 0) + " s";
  const auto minutes = std::llround(time_s / 60);
  if (minutes < 60) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

std::string bearing_text(double bearing_deg) {
  std::string digits = fixed(bearing_deg, 1);
  if (digits == "360.0") digits = "0.0";
  const std::size_t missing = std::string{"360.0"}.size() - digits.size();
  return std::string(missing, '0') + digits + "\u00B0";
}

}  // namespace selion
