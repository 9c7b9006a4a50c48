// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "box.hpp"

struct GEOSGeom_t;
struct GEOSPrepGeom_t;

namespace selion::verifying {

/// A polygon, lines, or several of them, held by GEOS; null for what GEOS could not make.
using Shape = std::shared_ptr<GEOSGeom_t>;

/// A polygon as corners: shell and holes, not closed.
struct Outline {
  std::vector<Point> shell;
  std::vector<std::vector<Point>> holes;
};

Shape polygon_of(std::span<const Point> corners);
Shape polygon_of(const Outline& outline);
Shape line_through(std::span<const Point> points);
Shape place_at(Point p);
bool is_valid(const Shape& shape);
/// A valid shape: rings that cross themselves are taken by even-odd.
Shape made_valid(const Shape& shape);
Shape border_of(const Shape& area);
/// Of all together; empty where there is none.
Shape united(const std::vector<Shape>& shapes);
/// The same of many valid polygons, in one pass.
Shape dissolved(const std::vector<Shape>& polygons);
/// Where two or more of them overlap.
Shape overlaps(const std::vector<Shape>& shapes);
Shape convex_hull(std::span<const Point> points);
Shape common(const Shape& a, const Shape& b);
Shape without(const Shape& a, const Shape& b);
/// Everything within `by_m`, corners rounded; below 0: shrunk.
Shape grown(const Shape& shape, double by_m);

double area_m2(const Shape& shape);
double perimeter_m(const Shape& shape);
double distance_m(const Shape& a, const Shape& b);
/// Around all of it.
Box box_of(const Shape& shape);
/// What of it lies in a box.
Shape within(const Shape& shape, const Box& box);
/// How far the farthest corner of `shape` lies from `from`.
double farthest_m(const Shape& shape, const Shape& from);
std::vector<Outline> outlines_of(const Shape& shape);
/// With its holes.
Shape filled(const Shape& area);
/// Of lines and rings, these with the first corner again at their end.
std::vector<std::vector<Point>> lines_of(const Shape& shape);
/// A place inside; of an empty shape none.
std::optional<Point> place_in(const Shape& shape);
/// Polygons by area, largest first.
std::vector<Shape> parts_of(const Shape& shape);
/// The smallest areas that lines cut out, however they cross.
std::vector<Shape> faces_of(const Shape& lines);

/// A shape that many are compared with.
class Prepared {
 public:
  explicit Prepared(Shape shape);

  [[nodiscard]] const Shape& shape() const { return shape_; }
  /// Does it touch the convex polygon of these corners, the line of two, or the one place?
  [[nodiscard]] bool touches(std::span<const Point> corners) const;
  [[nodiscard]] bool touches(const Shape& other) const;
  [[nodiscard]] bool holds(Point p) const;
  [[nodiscard]] double distance_m(std::span<const Point> corners) const;
  /// The place of it that is nearest; of an empty shape none.
  [[nodiscard]] std::optional<Point> nearest_to(Point p) const;

 private:
  Shape shape_;
  std::shared_ptr<const GEOSPrepGeom_t> prepared_;
};

}  // namespace selion::verifying
