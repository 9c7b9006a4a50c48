// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/geometry/polygon.hpp"

namespace selion {

/// Polygons whose edges are sorted into bands from south to north, to ask many times whether a point lies in
/// one of them.
class AreaIndex {
 public:
  /// @pre no two areas overlap.
  explicit AreaIndex(const std::vector<Polygon>& areas);

  /// Inside or on the border of one: the same answer as `contains`.
  [[nodiscard]] bool holds(Point p) const;

 private:
  struct Edge {
    Point a;
    Point b;
  };
  void take(const Ring& ring);
  [[nodiscard]] std::size_t band_of(double y_m) const;

  std::vector<Edge> edges_;
  double south_m_ = 0;
  double north_m_ = 0;
  std::vector<std::vector<Edge>> bands_;
};

}  // namespace selion
