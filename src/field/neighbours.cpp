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

void compare(const Field& earlier, Field& later) {
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

}  // namespace

void note_neighbours(std::vector<Field>& fields) {
  std::vector<LonLatBox> boxes;
  boxes.reserve(fields.size());
  for (const Field& field : fields) boxes.push_back(bounds(field.parts));
  std::vector<std::size_t> order(fields.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].low.lon_deg < boxes[b].low.lon_deg; });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1;
         j < order.size() && boxes[order[j]].low.lon_deg < boxes[order[i]].high.lon_deg; ++j) {
      const LonLatBox& a = boxes[order[i]];
      const LonLatBox& b = boxes[order[j]];
      if (a.low.lat_deg < b.high.lat_deg && b.low.lat_deg < a.high.lat_deg)
        pairs.emplace_back(std::minmax(order[i], order[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [earlier, later] : pairs) compare(fields[earlier], fields[later]);
}

}  // namespace selion
