// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/core/error.hpp"
#include "selion/geometry/polygon.hpp"

namespace selion {

/// An axis, modulo pi: the way swaths run, without saying which end comes first.
class DrivingDirection {
 public:
  static DrivingDirection radians(double anticlockwise_from_east_rad);
  static DrivingDirection bearing_deg(double clockwise_from_north_deg);

  /// In [0, pi).
  [[nodiscard]] double radians() const { return radians_; }
  /// In [0, 180).
  [[nodiscard]] double bearing_deg() const;

  friend bool operator==(const DrivingDirection&, const DrivingDirection&) = default;

 private:
  double radians_ = 0;
};

/// Expected number of swath pieces at this spacing over a random phase: (1/2w) sum |e . n| over all edges,
/// holes included.
double expected_pieces(const Polygon& area, DrivingDirection along, double spacing_m);

/// The edge direction with the fewest expected pieces: exact, for concave areas and holes too (each term is
/// concave between edge directions, so the minimum lies at one). Of equal ones the longer edge, then the
/// smaller bearing.
DrivingDirection best_edge_direction(const Polygon& area);

/// The rule of Cariou et al. 2020, section II.E: the field is turned by whole degrees, the bounding box's
/// longer side must lie along the driving axis, no line along it may leave and re-enter the field; smallest
/// box wins.
struct P3Direction {
  DrivingDirection along;
  double rotation_deg = 0;  ///< anticlockwise rotation of the field, 1 ... 180: the paper's angle
  double box_m2 = 0;
};
/// Infeasible where no rotation passes the rule (complex concave fields, holes).
Result<P3Direction> p3_direction(const Polygon& area);

}  // namespace selion
