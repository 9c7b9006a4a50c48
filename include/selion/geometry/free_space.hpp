// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "selion/geometry/area_index.hpp"

namespace selion {

/// An area whose border is indexed, to ask many times whether something convex fits inside.
class FreeSpace {
 public:
  /// `reach_m`: how far the shapes asked about stretch from their reference point; only speed hangs on it.
  FreeSpace(const Polygon& area, double reach_m);

  [[nodiscard]] const Polygon& area() const { return area_; }
  [[nodiscard]] bool holds(Point p) const { return index_.holds(p); }
  /// Does no part of the border enter the convex `shape` (anticlockwise, two or more corners)? A shape that
  /// touches no border is inside or outside as a whole: that is for the caller to know.
  [[nodiscard]] bool clear(std::span<const Point> shape) const;
  /// A quick yes: nothing of the border lies within reach of p.
  [[nodiscard]] bool far_from_border(Point p) const { return near_[cell_of(p)] == 0; }
  /// A quick yes: nothing of the border lies in the box.
  [[nodiscard]] bool empty(const Box& box) const;

 private:
  struct Edge {
    Point a;
    Point b;
  };
  struct Cells {
    int left, right, bottom, top;
  };
  [[nodiscard]] int column_of(double x_m) const;
  [[nodiscard]] int row_of(double y_m) const;
  [[nodiscard]] std::size_t cell_of(Point p) const { return index(column_of(p.x_m), row_of(p.y_m)); }
  [[nodiscard]] Cells cells_of(const Box& box) const;
  [[nodiscard]] std::size_t index(int column, int row) const;
  void mark_near(const Cells& cells);
  using Crossing = std::pair<std::size_t, std::uint32_t>;  ///< cell, edge
  void add(std::uint32_t edge, double reach_m, std::vector<Crossing>& crossings);
  void pack(std::vector<Crossing> crossings);

  Polygon area_;
  AreaIndex index_;
  std::vector<Edge> edges_;
  Point low_;
  double cell_m_ = 1;
  double cells_per_m_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;     // cell -> where its edges begin in crossing_; one more at the end
  std::vector<std::uint32_t> crossing_;  // edges whose box meets the cell
  std::vector<unsigned char> near_;      // cell -> an edge lies within reach
};

}  // namespace selion
