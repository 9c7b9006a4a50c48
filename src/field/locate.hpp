// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "georeference.hpp"
#include "raw.hpp"
#include "selion/field/field.hpp"

namespace selion {

/// A feature in WGS84.
struct Located {
  std::vector<LonLatPolygon> polygons;
  std::vector<std::vector<LonLat>> lines;
  std::vector<LonLat> points;
  std::optional<double> datum_accuracy_m;
  std::vector<std::string> notes;
};

/// Every coordinate checked and brought to WGS84; rings opened (their closing corner dropped, or noted as
/// missing).
/// @throws InputError naming part, ring and coordinate, for rings of less than three corners, for rings
/// around a pole, and for a datum step worse than `accept_datum_error_m` (5 m where absent).
Located located(const RawFeature& feature, Georeference& georeference, const std::string& where,
                std::optional<double> accept_datum_error_m);

/// What holds a feature's coordinates, in its own CRS.
struct RawBox {
  RawPoint low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  RawPoint high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(RawPoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  [[nodiscard]] RawPoint middle() const {
    return {low.x + (high.x - low.x) / 2, low.y + (high.y - low.y) / 2};
  }
  [[nodiscard]] bool empty() const { return low.x > high.x; }
};
RawBox box_of(const RawFeature& feature);

/// Whether the feature is more than 100 km across: an extent, a country, but no field.
bool implausibly_large(const RawBox& box, Georeference& georeference);

/// Metres on WGS84's tangent plane at `reference`: exact enough within some kilometres, across the
/// antimeridian too.
Point tangent(LonLat p, LonLat reference);
LonLat from_tangent(Point p, LonLat reference);

struct LonLatBox {
  LonLat low;
  LonLat high;  ///< east of `low`: beyond 180 where the box crosses the antimeridian
};
LonLatBox bounds(const std::vector<LonLatPolygon>& polygons);

/// An obstacle's outline from any geometry: polygons as they are, a point as 16 sides around its `radius_m`,
/// a line as a band `width_m` wide (2 cm where absent).
/// @throws InputError for a point without `radius_m`, an outline without area, and for numbers that are none.
std::vector<LonLatPolygon> outlines(const Located& feature, const RawFeature& raw, const std::string& where);
/// A positive number of up to 10 km among the attributes, its key in any case. @throws InputError where it is
/// something else.
std::optional<double> metres_attribute(const RawFeature& raw, const std::string& key,
                                       const std::string& where);

}  // namespace selion
