// SPDX-License-Identifier: GPL-3.0-or-later
#include "geos.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <geos_c.h>

#include "geos_held.hpp"

namespace selion::verifying {
namespace {

GEOSCoordSequence* sequence_of(std::span<const Point> points, bool closed) {
  std::vector<double> numbers;
  numbers.reserve(2 * points.size() + 2);
  for (const Point p : points) numbers.insert(numbers.end(), {p.x_m, p.y_m});
  if (closed && !points.empty()) numbers.insert(numbers.end(), {points.front().x_m, points.front().y_m});
  return GEOSCoordSeq_copyFromBuffer_r(handle(), numbers.data(), static_cast<unsigned>(numbers.size() / 2), 0,
                                       0);
}

GEOSGeometry* ring_of(std::span<const Point> corners) {
  return GEOSGeom_createLinearRing_r(handle(), sequence_of(corners, true));
}

Shape simple(std::span<const Point> corners) {
  if (corners.size() == 1) return place_at(corners[0]);
  return corners.size() == 2 ? line_through(corners) : polygon_of(corners);
}

Shape collected(const std::vector<Shape>& shapes) {
  std::vector<GEOSGeometry*> members;
  for (const Shape& shape : shapes)
    if (shape) members.push_back(GEOSGeom_clone_r(handle(), shape.get()));
  return held(GEOSGeom_createCollection_r(handle(), GEOS_GEOMETRYCOLLECTION, members.data(),
                                          static_cast<unsigned>(members.size())));
}

}  // namespace

GEOSContextHandle_HS* handle() {
  struct Ends {
    void operator()(GEOSContextHandle_t context) const { GEOS_finish_r(context); }
  };
  thread_local const std::unique_ptr<GEOSContextHandle_HS, Ends> context{GEOS_init_r()};
  return context.get();
}

Shape held(GEOSGeom_t* geometry) {
  return {geometry, [](GEOSGeometry* g) {
            if (g != nullptr) GEOSGeom_destroy_r(handle(), g);
          }};
}

Shape polygon_of(std::span<const Point> corners) {
  return held(GEOSGeom_createPolygon_r(handle(), ring_of(corners), nullptr, 0));
}

Shape polygon_of(const Outline& outline) {
  std::vector<GEOSGeometry*> holes;
  for (const auto& hole : outline.holes)
    if (hole.size() > 2) holes.push_back(ring_of(hole));
  return held(GEOSGeom_createPolygon_r(handle(), ring_of(outline.shell), holes.data(),
                                       static_cast<unsigned>(holes.size())));
}

Shape line_through(std::span<const Point> points) {
  return held(GEOSGeom_createLineString_r(handle(), sequence_of(points, false)));
}

Shape place_at(Point p) { return held(GEOSGeom_createPointFromXY_r(handle(), p.x_m, p.y_m)); }

bool is_valid(const Shape& shape) { return shape && GEOSisValid_r(handle(), shape.get()) == 1; }

Shape made_valid(const Shape& shape) {
  if (!shape || is_valid(shape)) return shape;
  return held(GEOSMakeValid_r(handle(), shape.get()));
}

Shape border_of(const Shape& area) { return held(GEOSBoundary_r(handle(), area.get())); }
Shape united(const std::vector<Shape>& shapes) {
  return held(GEOSUnaryUnion_r(handle(), collected(shapes).get()));
}
Shape dissolved(const std::vector<Shape>& polygons) {
  constexpr int kPerQuarter = 1;  // nothing is rounded
  // Grown by nothing: all borders are cut at once, where a union of one after another cuts them over and
  // over.
  Shape all = held(GEOSBuffer_r(handle(), collected(polygons).get(), 0, kPerQuarter));
  return all ? all : united(polygons);
}
Shape convex_hull(std::span<const Point> points) {
  return held(GEOSConvexHull_r(handle(), line_through(points).get()));
}

Box box_of(const Shape& shape) {
  Box box;
  if (!shape || GEOSisEmpty_r(handle(), shape.get()) != 0) return box;
  GEOSGeom_getXMin_r(handle(), shape.get(), &box.low.x_m);
  GEOSGeom_getYMin_r(handle(), shape.get(), &box.low.y_m);
  GEOSGeom_getXMax_r(handle(), shape.get(), &box.high.x_m);
  GEOSGeom_getYMax_r(handle(), shape.get(), &box.high.y_m);
  return box;
}

Shape within(const Shape& shape, const Box& box) {
  return common(shape, polygon_of(std::array{box.low, Point{box.high.x_m, box.low.y_m}, box.high,
                                             Point{box.low.x_m, box.high.y_m}}));
}

Shape overlaps(const std::vector<Shape>& shapes) {
  std::vector<Box> boxes;
  boxes.reserve(shapes.size());
  for (const Shape& shape : shapes) boxes.push_back(box_of(shape));
  std::vector<Shape> pairs;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Prepared prepared{shapes[i]};
    for (std::size_t k = 0; k < i; ++k) {
      if (apart(boxes[i], boxes[k])) continue;
      if (!prepared.touches(shapes[k])) continue;
      if (Shape both = common(shapes[i], shapes[k]); area_m2(both) > 0) pairs.push_back(std::move(both));
    }
  }
  return united(pairs);
}

Shape common(const Shape& a, const Shape& b) { return held(GEOSIntersection_r(handle(), a.get(), b.get())); }
Shape without(const Shape& a, const Shape& b) { return held(GEOSDifference_r(handle(), a.get(), b.get())); }

Shape grown(const Shape& shape, double by_m) {
  constexpr int kPerQuarter = 8;
  return held(GEOSBuffer_r(handle(), shape.get(), by_m, kPerQuarter));
}

double area_m2(const Shape& shape) {
  double area = 0;
  if (shape) GEOSArea_r(handle(), shape.get(), &area);
  return area;
}

double perimeter_m(const Shape& shape) {
  double length = 0;
  if (shape) GEOSLength_r(handle(), shape.get(), &length);
  return length;
}

double distance_m(const Shape& a, const Shape& b) {
  double distance = std::numeric_limits<double>::infinity();
  if (a && b && GEOSisEmpty_r(handle(), a.get()) != 1 && GEOSisEmpty_r(handle(), b.get()) != 1)
    GEOSDistance_r(handle(), a.get(), b.get(), &distance);
  return distance;
}

double farthest_m(const Shape& shape, const Shape& from) {
  double most = 0;
  const auto far = [&](Point p) { most = std::max(most, distance_m(place_at(p), from)); };
  for (const Outline& outline : outlines_of(shape)) {
    for (const Point p : outline.shell) far(p);
    for (const auto& hole : outline.holes)
      for (const Point p : hole) far(p);
  }
  return most;
}

Prepared::Prepared(Shape shape)
    : shape_{shape ? std::move(shape) : united({})},
      prepared_{GEOSPrepare_r(handle(), shape_.get()), [](const GEOSPreparedGeometry* p) {
                  if (p != nullptr) GEOSPreparedGeom_destroy_r(handle(), p);
                }} {}

bool Prepared::touches(std::span<const Point> corners) const {
  return GEOSPreparedIntersects_r(handle(), prepared_.get(), simple(corners).get()) != 0;
}

bool Prepared::touches(const Shape& other) const {
  return GEOSPreparedIntersects_r(handle(), prepared_.get(), other.get()) != 0;
}

bool Prepared::holds(Point p) const {
  return GEOSPreparedContains_r(handle(), prepared_.get(), place_at(p).get()) == 1;
}

double Prepared::distance_m(std::span<const Point> corners) const {
  double distance = std::numeric_limits<double>::infinity();
  GEOSPreparedDistance_r(handle(), prepared_.get(), simple(corners).get(), &distance);
  return distance;
}

std::optional<Point> Prepared::nearest_to(Point p) const {
  GEOSCoordSequence* both = GEOSPreparedNearestPoints_r(handle(), prepared_.get(), place_at(p).get());
  if (both == nullptr) return std::nullopt;
  Point nearest;
  GEOSCoordSeq_getXY_r(handle(), both, 0, &nearest.x_m, &nearest.y_m);
  GEOSCoordSeq_destroy_r(handle(), both);
  return nearest;
}

}  // namespace selion::verifying
