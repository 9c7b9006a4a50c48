// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/core/point.hpp"

namespace selion {

/// Corners in order, the last one joined to the first (which is not repeated).
using Ring = std::vector<Point>;

/// An area: one shell, anticlockwise, and holes, clockwise, inside it.
struct Polygon {
  Ring shell;
  std::vector<Ring> holes;

  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Anticlockwise positive.
double signed_area_m2(const Ring& ring);
double perimeter_m(const Ring& ring);
/// Of shell and holes.
double perimeter_m(const Polygon& area);
/// Holes taken off.
double area_m2(const Polygon& area);
double area_m2(const std::vector<Polygon>& areas);
/// Of the area, holes taken off; of the shell's corners where the area is zero.
Point centroid(const Polygon& area);
/// Inside or on the border: decided by exact signs on the given coordinates.
bool contains(const Ring& ring, Point p);
bool contains(const Polygon& area, Point p);

/// Anticlockwise, without corners on its sides (Andrew 1979).
Ring convex_hull(Ring points);

struct Box {
  Point low;
  Point high;

  friend bool operator==(const Box&, const Box&) = default;
};
/// @pre at least one corner.
Box bounds(const Ring& ring);
/// Do they overlap, or touch?
bool meet(const Box& a, const Box& b);

}  // namespace selion
