// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "clean.hpp"
#include "locate.hpp"
#include "names.hpp"
#include "selion/core/error.hpp"
#include "selion/geometry/boolean.hpp"
#include "text.hpp"

namespace selion {
namespace {

Ring tangent(const LonLatRing& ring, LonLat reference) {
  Ring result;
  result.reserve(ring.size());
  for (const LonLat p : ring) result.push_back(tangent(p, reference));
  return result;
}

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
  for (const Polygon& piece : band(tangent(line, line.front()), width_m)) {
    LonLatPolygon one{from_tangent(piece.shell, line.front()), {}};
    for (const Ring& hole : piece.holes) one.holes.push_back(from_tangent(hole, line.front()));
    result.push_back(std::move(one));
  }
  return result;
}

bool is_without_area(const LonLatPolygon& outline) {
  if (outline.shell.empty()) return true;
  const LonLat reference = outline.shell.front();
  Polygon area{tangent(outline.shell, reference), {}};
  for (const LonLatRing& hole : outline.holes) area.holes.push_back(tangent(hole, reference));
  return is_sliver(unite({area}));
}

/// What is left of them would be driven over.
void refuse_without_extent(const Located& feature, const std::string& where) {
  const auto number = [](std::size_t i, std::size_t of, const char* what) {
    return of > 1 ? what + std::to_string(i + 1) : "";
  };
  for (std::size_t i = 0; i < feature.polygons.size(); ++i) {
    const LonLatRing& shell = feature.polygons[i].shell;
    if (is_without_area(feature.polygons[i]))
      throw InputError{where + number(i, feature.polygons.size(), ", part ") +
                       " is an obstacle without area: nothing of it is wider than 1 cm" +
                       (shell.empty() ? "" : " near " + place(shell.front())) +
                       "; correct its outline, or give it as a line with its width as a property width_m"};
  }
  for (std::size_t i = 0; i < feature.lines.size(); ++i) {
    const std::vector<LonLat>& line = feature.lines[i];
    if (std::ranges::all_of(line, [&](LonLat p) { return p == line.front(); }))
      throw InputError{where + number(i, feature.lines.size(), ", line ") + " is an obstacle without length" +
                       (line.empty() ? "" : " near " + place(line.front())) +
                       "; correct it, or give it as a point with its size as a property radius_m"};
  }
}

}  // namespace

std::optional<double> metres_attribute(const RawFeature& raw, const std::string& key,
                                       const std::string& where) {
  constexpr double kFarthest_m = 10e3;
  const std::string* found = attribute(raw, key);
  if (found == nullptr) return std::nullopt;
  const std::string& text = *found;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value > 0) || !std::isfinite(value))
    throw InputError{where + ": its " + key + " is '" + text.substr(0, 40) +
                     "', but must be a positive number of metres"};
  if (value > kFarthest_m)
    throw InputError{where + ": its " + key + " is '" + text.substr(0, 40) +
                     "', more than 10 km; correct it (it counts metres)"};
  return value;
}

std::vector<LonLatPolygon> outlines(const Located& feature, const RawFeature& raw, const std::string& where) {
  constexpr double kLine_m = 0.02;
  refuse_without_extent(feature, where);
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
