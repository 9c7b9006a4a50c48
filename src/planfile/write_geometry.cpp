// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_geometry.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace selion {
namespace {

constexpr double kUnitsPerDegree = 1e9;  // one unit of the last decimal

/// Twice the area, in units of the last decimal, of the ring as it will stand in the file: an unrounded
/// sliver could have the other sign, and would be turned about when the file is read and written again.
double doubled_area(const LonLatLine& ring) {
  const auto from_first = [&](std::size_t i) {
    const auto units = [](double deg) { return std::round(deg * kUnitsPerDegree); };
    return Point{units(ring[i].lon_deg) - units(ring[0].lon_deg),
                 units(ring[i].lat_deg) - units(ring[0].lat_deg)};
  };
  double area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) area += cross(from_first(i), from_first(i + 1));
  return area;
}

LonLat rounded(LonLat position) {
  const auto to_units = [](double deg) { return std::round(deg * kUnitsPerDegree) / kUnitsPerDegree; };
  return {to_units(position.lon_deg), to_units(position.lat_deg)};
}

/// RFC 7946, section 3.1.6: closed, shells anticlockwise, holes clockwise. The first corner stays the first.
void write_ring(JsonWriter& json, const LonLatLine& ring, double sign) {
  const bool turn = sign * doubled_area(ring) < 0;
  json.begin_array(JsonSpread::line);
  for (std::size_t i = 0; i <= ring.size(); ++i)
    write_position(json, ring[(turn ? ring.size() - i : i) % ring.size()]);
  json.end();
}

void write_rings(JsonWriter& json, const LonLatArea& area) {
  json.begin_array(JsonSpread::line);
  write_ring(json, area.shell, 1);
  for (const LonLatLine& hole : area.holes) write_ring(json, hole, -1);
  json.end();
}

JsonWriter& begin_geometry(JsonWriter& json, const char* type) {
  json.end().key("geometry").begin_object(JsonSpread::line);
  return json.key("type").text(type).key("coordinates");
}

}  // namespace

void check(const std::string& what, const Problem& problem) {
  if (problem) throw std::logic_error{what + ": " + *problem};
}

int at_least(int low, int value, const char* key) {
  if (value < low)
    throw std::logic_error{std::string{key} + " is " + std::to_string(value) + ", it must be at least " +
                           std::to_string(low)};
  return value;
}

void begin_feature(JsonWriter& json, const char* kind) {
  json.begin_object(JsonSpread::line).key("type").text("Feature");
  json.key("properties").begin_object(JsonSpread::line).key("kind").text(kind);
}

void begin_feature(JsonWriter& json, const char* kind, int block) {
  begin_feature(json, kind);
  json.key("block").whole(at_least(1, block, "block"));
}

void end_feature(JsonWriter& json, LonLat point) {
  check("a feature", problem_of(point));
  begin_geometry(json, "Point");
  write_position(json, point);
  json.end().end();
}

void end_feature(JsonWriter& json, const LonLatLine& line) {
  check("a feature", problem_of_line(line));
  begin_geometry(json, "LineString").begin_array(JsonSpread::line);
  for (const LonLat position : line) write_position(json, position);
  json.end().end().end();
}

void end_feature(JsonWriter& json, const std::vector<LonLatArea>& parts) {
  check("a feature", problem_of(parts));
  begin_geometry(json, parts.size() == 1 ? "Polygon" : "MultiPolygon");
  if (parts.size() == 1) {
    write_rings(json, parts.front());
  } else {
    json.begin_array(JsonSpread::line);
    for (const LonLatArea& part : parts) write_rings(json, part);
    json.end();
  }
  json.end().end();
}

void write_position(JsonWriter& json, LonLat position) {
  const LonLat at = rounded(position);
  json.begin_array(JsonSpread::line)
      .number(at.lon_deg, kCoordinateDecimals)
      .number(at.lat_deg, kCoordinateDecimals)
      .end();
}

}  // namespace selion
