// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "locate.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "selion/geometry/boolean.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr std::uint16_t kMostOfEach = 1000;  // overlapping extents
constexpr int kMostTold = 10;

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

/// Empty where they do not overlap.
std::string shared_ground(const Field& earlier, const Field& later) {
  if (earlier.parts == later.parts)
    return later.source + " has the same boundary as feature " + std::to_string(earlier.number);
  constexpr double kShare = 0.01;
  constexpr double kHalfWidth_m = 0.5;
  const LonLat reference = earlier.parts.front().shell.front();
  const Polygons a = in_plane(earlier.parts, reference);
  const Polygons b = in_plane(later.parts, reference);
  const Polygons common = intersect(a, b);
  const double common_m2 = area_m2(common);
  if (common_m2 < kShare * std::min(area_m2(a), area_m2(b)) || inset(common, kHalfWidth_m).empty()) return "";
  return later.source + " overlaps feature " + std::to_string(earlier.number) + " by " +
         fixed(hectares_of_m2(common_m2), 3) + " ha";
}

}  // namespace

bool NeighbourNotes::compare_with(const Field& earlier) {
  std::string note = shared_ground(earlier, field_);
  if (note.empty()) return true;
  const bool enough = told_++ == kMostTold;
  field_.notes.push_back(enough ? field_.source + " overlaps other features too" : std::move(note));
  return !enough;
}

std::vector<Overlap> overlaps_of(const std::vector<FieldExtent>& extents) {
  std::vector<std::uint32_t> order(extents.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return extents[a].low_x < extents[b].low_x; });
  std::vector<Overlap> overlaps;
  std::vector<std::uint16_t> known(extents.size(), 0);  // of each later one
  for (std::size_t i = 0; i < order.size(); ++i) {
    const FieldExtent& a = extents[order[i]];
    for (std::size_t j = i + 1; j < order.size() && extents[order[j]].low_x < a.high_x; ++j) {
      const FieldExtent& b = extents[order[j]];
      if (!(a.low_y < b.high_y && b.low_y < a.high_y)) continue;
      const std::uint32_t later = std::max(order[i], order[j]);
      if (known[later] == kMostOfEach) continue;
      ++known[later];
      overlaps.push_back({later, std::min(order[i], order[j])});
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
  const std::vector<Overlap> overlaps = overlaps_of(extents);
  for (auto at = overlaps.begin(); at != overlaps.end();) {
    const std::uint32_t later = at->later;
    NeighbourNotes notes{fields[later]};
    while (at != overlaps.end() && at->later == later && notes.compare_with(fields[at->earlier])) ++at;
    at = std::find_if(at, overlaps.end(), [later](const Overlap& other) { return other.later != later; });
  }
}

}  // namespace selion
