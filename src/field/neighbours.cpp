// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours.hpp"

#include <algorithm>
#include <numeric>

#include "locate.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "selion/geometry/boolean.hpp"
#include "text.hpp"

namespace selion {
namespace {

Polygons in_plane(const std::vector<LonLatPolygon>& parts, LonLat reference) {
  Polygons result;
  const auto ring = [&](const LonLatRing& corners) {
    Ring plane;
    plane.reserve(corners.size());
    for (const LonLat p : corners) plane.push_back(tangent(p, reference));
    return plane;
  };
  for (const LonLatPolygon& part : parts) {
    Polygon polygon{ring(part.shell), {}};
    for (const LonLatRing& hole : part.holes) polygon.holes.push_back(ring(hole));
    result.push_back(std::move(polygon));
  }
  return result;
}

}  // namespace

void note_neighbour(const Field& earlier, Field& later) {
  if (earlier.parts == later.parts) {
    later.notes.push_back(later.source + " has the same boundary as feature " +
                          std::to_string(earlier.number));
    return;
  }
  constexpr double kShare = 0.01;
  constexpr double kHalfWidth_m = 0.5;
  const LonLat reference = earlier.parts.front().shell.front();
  const Polygons a = in_plane(earlier.parts, reference);
  const Polygons b = in_plane(later.parts, reference);
  const Polygons common = intersect(a, b);
  const double common_m2 = area_m2(common);
  if (common_m2 < kShare * std::min(area_m2(a), area_m2(b)) || inset(common, kHalfWidth_m).empty()) return;
  later.notes.push_back(later.source + " overlaps feature " + std::to_string(earlier.number) + " by " +
                        fixed(hectares_of_m2(common_m2), 3) + " ha");
}

std::vector<Overlap> overlaps_of(const std::vector<FieldExtent>& extents) {
  std::vector<std::uint32_t> order(extents.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return extents[a].low_x < extents[b].low_x; });
  std::vector<Overlap> overlaps;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const FieldExtent& a = extents[order[i]];
    for (std::size_t j = i + 1; j < order.size() && extents[order[j]].low_x < a.high_x; ++j) {
      const FieldExtent& b = extents[order[j]];
      if (a.low_y < b.high_y && b.low_y < a.high_y)
        overlaps.push_back({std::max(order[i], order[j]), std::min(order[i], order[j])});
    }
  }
  std::sort(overlaps.begin(), overlaps.end());
  return overlaps;
}

void note_neighbours(std::vector<Field>& fields) {
  std::vector<FieldExtent> extents;
  extents.reserve(fields.size());
  for (const Field& field : fields) {
    const auto [low, high] = bounds(field.parts);
    extents.push_back({low.lon_deg, low.lat_deg, high.lon_deg, high.lat_deg});
  }
  for (const auto& [later, earlier] : overlaps_of(extents)) note_neighbour(fields[earlier], fields[later]);
}

}  // namespace selion
