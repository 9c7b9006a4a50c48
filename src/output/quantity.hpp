// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "selion/output/map.hpp"

namespace selion {

// Quantities as a person reads them, in the units asked for.

/// "5.09 ha", "12.58 ac"; below a hundredth of one "62 m²", "320 ft²".
std::string area_text(double area_m2, Units units);
/// "3.00 m", "9.84 ft".
std::string length_text(double length_m, int decimals, Units units);
/// "18.4 km", "11.4 mi"; below one of them "640 m", "2100 ft".
std::string distance_text(double distance_m, Units units);
/// "3 h 42 min", "42 min"; below a minute "35 s".
std::string time_text(double time_s);
/// A compass bearing with three digits before the point: "012.5°".
std::string bearing_text(double bearing_deg);

}  // namespace selion
