// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "selion/core/point.hpp"
#include "selion/geometry/polygon.hpp"
#include "selion/motion/path.hpp"

namespace selion {

/// The point of a curve or path next to a place.
struct Nearest {
  double station_m = 0;  ///< along the curve, or along the whole path
  double offset_m =
      0;  ///< the distance; positive where the place lies left of the way there, with respect to travel
  Point at;
};

/// The nearest point of the whole curve: no other is nearer, but for rounding (1e-14 of the distance). Of
/// several at one distance, any. By branch and bound: a stretch is left out where the distance's derivatives
/// show that it cannot come near enough, and searched by Newton's method where they show that it has one
/// minimum.
/// @pre the length is at least 0.
Nearest nearest_on(const Curve& curve, Point place);
/// None where the path is empty.
std::optional<Nearest> nearest_on(const Path& path, Point place);

/// The smallest upright rectangle that holds the whole curve, exact but for rounding: its sides touch the
/// ends or points where the heading crosses an axis. A spiral's inner turns lie within its outermost (Tait
/// 1896, Kneser 1912), so a curve of many turns costs no more.
Box box_of(const Curve& curve);
/// None where the path is empty.
std::optional<Box> box_of(const Path& path);

}  // namespace selion
