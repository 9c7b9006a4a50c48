// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "box.hpp"

namespace selion::verifying {

using Corners = std::array<Point, 4>;

/// Between convex quadrilaterals, which may be flat; 0 where they touch.
double distance_m(const Corners& a, const Corners& b);

struct Segment {
  Point from;
  Point to;
};

/// The segments of lines, in a tree of boxes around neighbours. Of lines with numbers that are none: none.
class Segments {
 public:
  explicit Segments(const std::vector<std::vector<Point>>& lines);

  /// True only where the rectangle of these corners lies off every segment by a micrometre or more.
  [[nodiscard]] bool clear_of(const Corners& corners) const;
  /// How far the farthest of some places lies from the segment nearest to it; quick where the places follow
  /// the lines. Infinite where there is no segment, or a number is none.
  [[nodiscard]] double farthest_m(std::span<const Point> places) const;
  /// Do more than `crossings` of its pairs cross, or the boxes around more than `beside` of them meet?
  [[nodiscard]] bool tangled(int crossings, int beside) const;

 private:
  struct Nearest {
    std::size_t segment = 0;
    double distance_m = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] bool clear_of(const Corners& corners, const Box& around, std::size_t level,
                              std::size_t i) const;
  struct Pairs {
    int crossings;
    int beside;
  };
  /// Takes the pairs of a box with itself, or of two, off `left`; false where that gets below 0.
  bool take_pairs(std::size_t level, std::size_t i, std::size_t k, Pairs& left) const;
  static bool take_pair(const Segment& e, const Segment& f, Pairs& left);
  /// Of a segment and those behind it, as long as they come nearer.
  [[nodiscard]] Nearest followed(Point p, std::size_t from) const;
  void look_for(Point p, std::size_t level, std::size_t i, Nearest& nearest) const;
  [[nodiscard]] std::size_t end_of(std::size_t level, std::size_t i) const;

  std::vector<Segment> segments_;
  std::vector<std::vector<Box>> levels_;  ///< of each box some of the level before; the first of segments
};

}  // namespace selion::verifying
