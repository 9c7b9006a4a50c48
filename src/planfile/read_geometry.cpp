// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_geometry.hpp"

#include <string>

namespace selion {
namespace {

JsonNode coordinates(const JsonNode& feature, const std::string& type) {
  const JsonNode geometry = feature.at("geometry");
  const std::string found = geometry.at("type").text();
  if (found != type) geometry.fail("must be a " + type + ", not a " + found);
  return geometry.at("coordinates");
}

LonLatLine read_ring(const JsonNode& node) {
  LonLatLine ring = node.positions();
  if (ring.size() < 4) node.fail("has " + std::to_string(ring.size()) + " positions, a closed ring needs 4");
  if (ring.front() != ring.back()) node.fail("is not closed: its last position must repeat its first");
  ring.pop_back();
  return ring;
}

LonLatArea read_rings(const JsonNode& node) {
  const std::vector<JsonNode> rings = node.items();
  if (rings.empty()) node.fail("has no ring, a polygon needs one");
  LonLatArea area;
  area.shell = read_ring(rings.front());
  for (std::size_t i = 1; i < rings.size(); ++i) area.holes.push_back(read_ring(rings[i]));
  return area;
}

}  // namespace

void check(const JsonNode& node, const Problem& problem) {
  if (problem) node.fail("is wrong: " + *problem);
}

LonLat read_point(const JsonNode& feature) {
  const JsonNode node = coordinates(feature, "Point");
  const LonLat point = node.position();
  check(node, problem_of(point));
  return point;
}

LonLatLine read_line(const JsonNode& feature) {
  const JsonNode node = coordinates(feature, "LineString");
  LonLatLine line = node.positions();
  check(node, problem_of_line(line));
  return line;
}

std::vector<LonLatArea> read_parts(const JsonNode& feature) {
  std::vector<LonLatArea> parts;
  if (feature.at("geometry").at("type").text() == "MultiPolygon") {
    for (const JsonNode& part : coordinates(feature, "MultiPolygon").items())
      parts.push_back(read_rings(part));
  } else {
    parts.push_back(read_rings(coordinates(feature, "Polygon")));
  }
  check(feature.at("geometry"), problem_of(parts));
  return parts;
}

}  // namespace selion
