// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/geometry/polygon.hpp"

namespace selion {

/// Booleans and offsets on a grid of 1 um (Clipper: Vatti 1992, exact integer arithmetic). Input may touch or
/// overlap itself; output is clean: shells anticlockwise, holes clockwise, largest part first, no part below
/// 1 mm2.
using Polygons = std::vector<Polygon>;

Polygons unite(const Polygons& areas);
Polygons intersect(const Polygons& a, const Polygons& b);
Polygons subtract(const Polygons& a, const Polygons& b);

/// Turned about the origin. The booleans' sweep runs from south to north: long strips side by side are united
/// many times faster where they lie from west to east.
Polygons turned(Polygons areas, double by_rad);

/// `areas`, none of which overlaps itself or another, shrunk by `distance_m` >= 0 on every side. Mitred:
/// corners stay sharp.
Polygons inset(const Polygons& areas, double distance_m);
/// Shrunk with rounded reflex corners: exactly the places at least `distance_m` from the border.
Polygons inset_round(const Polygons& areas, double distance_m);
/// Grown by `distance_m` >= 0, corners rounded to within 1 mm.
Polygons outset_round(const Polygons& areas, double distance_m);
/// Grown by `distance_m` >= 0, corners sharp up to `miter_limit` times the distance.
Polygons outset(const Polygons& areas, double distance_m, double miter_limit);

/// The band within half of `width_m` of a line, its ends cut square. The line may cross itself.
Polygons band(const std::vector<Point>& line, double width_m);

/// The parts of segment a-b inside `areas`, in order from a.
struct Span1 {
  double from_m = 0;
  double to_m = 0;
};
std::vector<Span1> inside_spans(Point a, Point b, const Polygons& areas);

}  // namespace selion
