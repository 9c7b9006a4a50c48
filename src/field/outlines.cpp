// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>
#include <numbers>

#include "locate.hpp"
#include "selion/core/error.hpp"
#include "selion/geometry/boolean.hpp"

namespace selion {
namespace {

LonLatRing from_tangent(const Ring& ring, LonLat reference) {
  LonLatRing result;
  result.reserve(ring.size());
  for (const Point p : ring) result.push_back(from_tangent(p, reference));
  return result;
}

/// Around the circle, not in it: nothing of the obstacle sticks out.
LonLatPolygon circle(LonLat middle, double radius_m) {
  constexpr int kSides = 16;
  const double corner_m = radius_m / std::cos(std::numbers::pi / kSides);
  Ring ring;
  for (int i = 0; i < kSides; ++i) ring.push_back(corner_m * unit(2 * std::numbers::pi * i / kSides));
  return {from_tangent(ring, middle), {}};
}

std::vector<LonLatPolygon> bands(const std::vector<LonLat>& line, double width_m) {
  std::vector<LonLatPolygon> result;
  if (line.size() < 2) return result;
  std::vector<Point> plane;
  plane.reserve(line.size());
  for (const LonLat p : line) plane.push_back(tangent(p, line.front()));
  for (const Polygon& piece : band(plane, width_m)) {
    LonLatPolygon one{from_tangent(piece.shell, line.front()), {}};
    for (const Ring& hole : piece.holes) one.holes.push_back(from_tangent(hole, line.front()));
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace

std::optional<double> metres_attribute(const RawFeature& raw, const std::string& key,
                                       const std::string& where) {
  const auto found = raw.attributes.find(key);
  if (found == raw.attributes.end()) return std::nullopt;
  const std::string& text = found->second;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0) || !std::isfinite(value))
    throw InputError{where + ": its " + key + " is '" + text.substr(0, 40) +
                     "', but must be a positive number of metres"};
  return value;
}

std::vector<LonLatPolygon> outlines(const Located& feature, const RawFeature& raw, const std::string& where) {
  constexpr double kLine_m = 0.02;
  std::vector<LonLatPolygon> result = feature.polygons;
  const auto radius_m = metres_attribute(raw, "radius_m", where);
  if (!feature.points.empty() && !radius_m)
    throw InputError{where +
                     " is an obstacle given as a point: give its size as a property radius_m, or its outline "
                     "as a polygon"};
  for (const LonLat p : feature.points) result.push_back(circle(p, *radius_m));
  const double width_m = metres_attribute(raw, "width_m", where).value_or(kLine_m);
  for (const auto& line : feature.lines)
    for (LonLatPolygon& piece : bands(line, width_m)) result.push_back(std::move(piece));
  return result;
}

}  // namespace selion
