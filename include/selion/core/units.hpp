// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace selion {

constexpr double radians_of_degrees(double deg) { return deg * std::numbers::pi / 180; }
constexpr double degrees_of_radians(double rad) { return rad * 180 / std::numbers::pi; }
constexpr double hectares_of_m2(double m2) { return m2 / 1e4; }
constexpr double acres_of_m2(double m2) { return m2 / 4046.8564224; }
constexpr double feet_of_m(double m) { return m / 0.3048; }
constexpr double kmph_of_mps(double mps) { return mps * 3.6; }

}  // namespace selion
