// SPDX-License-Identifier: GPL-3.0-or-later
// What shapes of GEOS consist of.
#include <algorithm>
#include <cstddef>

#include <geos_c.h>

#include "geos.hpp"
#include "geos_held.hpp"

namespace selion::verifying {
namespace {

std::vector<Point> points_of(const GEOSGeometry* line) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(handle(), line);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(handle(), sequence, &size);
  std::vector<double> numbers(2 * std::size_t{size});
  GEOSCoordSeq_copyToBuffer_r(handle(), sequence, numbers.data(), 0, 0);
  std::vector<Point> points(size);
  for (std::size_t i = 0; i < size; ++i) points[i] = {numbers[2 * i], numbers[2 * i + 1]};
  return points;
}

std::vector<Point> corners_of(const GEOSGeometry* ring) {
  std::vector<Point> corners = points_of(ring);
  if (corners.size() > 1) corners.pop_back();  // the first one again
  return corners;
}

Outline outline_of(const GEOSGeometry* polygon) {
  Outline outline{corners_of(GEOSGetExteriorRing_r(handle(), polygon)), {}};
  for (int i = 0; i < GEOSGetNumInteriorRings_r(handle(), polygon); ++i)
    outline.holes.push_back(corners_of(GEOSGetInteriorRingN_r(handle(), polygon, i)));
  return outline;
}

}  // namespace

std::vector<Outline> outlines_of(const Shape& shape) {
  std::vector<Outline> outlines;
  for (const Shape& part : parts_of(shape)) outlines.push_back(outline_of(part.get()));
  return outlines;
}

std::vector<std::vector<Point>> lines_of(const Shape& shape) {
  std::vector<std::vector<Point>> lines;
  const auto take = [&lines](const GEOSGeometry* g, const auto& self) -> void {
    const int type = GEOSGeomTypeId_r(handle(), g);
    if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) {
      lines.push_back(points_of(g));
    } else if (type == GEOS_MULTILINESTRING) {
      for (int i = 0; i < GEOSGetNumGeometries_r(handle(), g); ++i)
        self(GEOSGetGeometryN_r(handle(), g, i), self);
    }
  };
  if (shape) take(shape.get(), take);
  return lines;
}

Shape filled(const Shape& area) {
  std::vector<Shape> shells;
  for (const Outline& outline : outlines_of(area)) shells.push_back(polygon_of(outline.shell));
  return united(shells);
}

std::optional<Point> place_in(const Shape& shape) {
  const Shape inside = held(GEOSPointOnSurface_r(handle(), shape.get()));
  Point p;
  if (!inside || GEOSisEmpty_r(handle(), inside.get()) == 1) return std::nullopt;
  GEOSGeomGetX_r(handle(), inside.get(), &p.x_m);
  GEOSGeomGetY_r(handle(), inside.get(), &p.y_m);
  return p;
}

std::vector<Shape> parts_of(const Shape& shape) {
  std::vector<Shape> parts;
  const auto take = [&parts](const GEOSGeometry* g, const auto& self) -> void {
    const int type = GEOSGeomTypeId_r(handle(), g);
    if (type == GEOS_POLYGON) {
      if (GEOSisEmpty_r(handle(), g) != 1) parts.push_back(held(GEOSGeom_clone_r(handle(), g)));
    } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
      for (int i = 0; i < GEOSGetNumGeometries_r(handle(), g); ++i)
        self(GEOSGetGeometryN_r(handle(), g, i), self);
    }
  };
  if (shape) take(shape.get(), take);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Shape& a, const Shape& b) { return area_m2(a) > area_m2(b); });
  return parts;
}

std::vector<Shape> faces_of(const Shape& lines) {
  const Shape cut = held(GEOSUnaryUnion_r(handle(), lines.get()));
  const GEOSGeometry* const all = cut.get();
  return parts_of(held(GEOSPolygonize_r(handle(), &all, 1)));
}

}  // namespace selion::verifying
