// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_samples.hpp"

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

namespace selion {
namespace {

const LonLat kOrigin{10, 50};

/// Closed segments share a place; within the rounding of doubles at field size.
bool cross_properly(Point a, Point b, Point c, Point d) {
  const double kRounding_m2 = 1e-6 * std::max(distance_m(a, b), distance_m(c, d));  // 1 um beside the edge
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  const auto opposite = [&](double s, double t) {
    return (s > kRounding_m2 && t < -kRounding_m2) || (s < -kRounding_m2 && t > kRounding_m2);
  };
  return opposite(c_side, d_side) && opposite(a_side, b_side);
}

std::string ring_fault(const Ring& ring) {
  if (ring.size() < 3) return "a ring has fewer than three corners";
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    if (distance_m(ring[i], ring[(i + 1) % n]) < 1e-3) return "an edge is shorter than 1 mm";
    if (distance_m(ring[i], ring[(i + 2) % n]) < 1e-3) return "a spike";
    for (std::size_t j = i + 2; j < n; ++j)
      if (cross_properly(ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]))
        return "a ring crosses itself";
  }
  return {};
}

bool rings_cross(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (cross_properly(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
  return false;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& name, std::string_view content)
    : folder_{std::filesystem::temp_directory_path() /
              ("selion_test_" + std::to_string(std::random_device{}()))},
      path_{folder_ / name} {
  std::filesystem::create_directories(folder_);
  std::ofstream{path_, std::ios::binary} << content;
}

TemporaryFile::~TemporaryFile() { std::filesystem::remove_all(folder_); }

std::vector<Field> read_file(const std::filesystem::path& file) { return read_file(file, {}); }

std::vector<Field> read_file(const std::filesystem::path& file, const ReadOptions& options) {
  std::istringstream nothing;
  return read_fields(file, options, nothing);
}

std::vector<Field> read_stdin(const std::string& geojson) { return read_stdin(geojson, {}); }

std::vector<Field> read_stdin(const std::string& geojson, const ReadOptions& options) {
  std::istringstream input{geojson};
  return read_fields("-", options, input);
}

LonLatPolygon polygon_of_metres(const Polygon& area) {
  static const LocalFrame frame = LocalFrame::centred(kOrigin);
  const auto ring = [](const Ring& corners) {
    LonLatRing result;
    for (const Point p : corners) result.push_back(frame.to_lonlat(p));
    return result;
  };
  LonLatPolygon polygon{ring(area.shell), {}};
  for (const Ring& hole : area.holes) polygon.holes.push_back(ring(hole));
  return polygon;
}

Field field_of_metres(const std::vector<Polygon>& parts) {
  Field field;
  field.name = "made";
  field.source = "made.geojson, feature 1";
  for (const Polygon& part : parts) field.parts.push_back(polygon_of_metres(part));
  return field;
}

Blocks blocks_of(const Field& field) { return blocks_of(field, LocalFrame::centred(centre(field)), {}); }

double blocks_area_m2(const Field& field) {
  double sum = 0;
  for (const Block& block : blocks_of(field).blocks) sum += area_m2(block.area);
  return sum;
}

bool mentions(const std::string& where, const std::string& word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(where.begin(), where.end(), word.begin(), word.end(), same) != where.end();
}

bool any_mentions(const std::vector<std::string>& notes, const std::string& word) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return mentions(note, word); });
}

std::string fault(const Polygon& area) {
  if (std::string own = ring_fault(area.shell); !own.empty()) return "shell: " + own;
  if (signed_area_m2(area.shell) <= 0) return "the shell is not anticlockwise";
  for (std::size_t i = 0; i < area.holes.size(); ++i) {
    const Ring& hole = area.holes[i];
    if (std::string own = ring_fault(hole); !own.empty()) return "hole: " + own;
    if (signed_area_m2(hole) >= 0) return "a hole is not clockwise";
    if (rings_cross(hole, area.shell)) return "a hole crosses the shell";
    if (std::none_of(hole.begin(), hole.end(), [&](Point p) { return contains(area.shell, p); }))
      return "a hole is outside";
    for (std::size_t j = 0; j < i; ++j)
      if (rings_cross(hole, area.holes[j])) return "two holes cross";
  }
  return {};
}

}  // namespace selion
