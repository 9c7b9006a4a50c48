// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/geometry/polygon.hpp"

namespace selion {

/// `ring` with fewer corners, each dropped one within `tolerance_m` of the new ring (Douglas and Peucker
/// 1973).
/// @returns the ring itself where fewer than three corners would be left.
Ring simplified(const Ring& ring, double tolerance_m);
/// As much, moved to the left where it cuts off what the ring has there, so that none of the ring's corners
/// lies left of it.
Ring simplified_to_left(const Ring& ring, double tolerance_m);
/// Each ring for itself.
Polygon simplified(const Polygon& area, double tolerance_m);

/// An area whose corners lie further apart, and how far its border may stray from the one that it was made
/// of.
struct Evened {
  Polygon area;
  double stray_m = 0;
};
/// Where corners lie closer together than a metre on average, or a thousand and more closer than 3 m, as
/// noise and drawn curves have them: simplified by as little as leaves fewer, at most 0.1 m. Else the area as
/// it is.
Evened evened(const Polygon& area);

}  // namespace selion
