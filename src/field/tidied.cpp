// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "clean.hpp"
#include "loops.hpp"

namespace selion {
namespace {

void tidy(Ring& ring) {
  for (bool changed = true; changed && ring.size() >= 3;) {
    changed = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() >= 3;) {
      const Point before = ring[(i + ring.size() - 1) % ring.size()];
      const Point after = ring[(i + 1) % ring.size()];
      const bool spike = distance_m(before, after) < kSnap_m;
      if (spike || distance_m(before, ring[i]) < kSnap_m) {
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
        changed = true;
      } else {
        ++i;
      }
    }
  }
}

void start_west(Ring& ring) {
  const auto west = std::min_element(ring.begin(), ring.end(), [](Point a, Point b) {
    return a.x_m != b.x_m ? a.x_m < b.x_m : a.y_m < b.y_m;
  });
  std::rotate(ring.begin(), west, ring.end());
}

}  // namespace

Polygon tidied(const Polygon& area) {
  Polygon result = area;
  tidy(result.shell);
  for (Ring& hole : result.holes) tidy(hole);
  std::erase_if(result.holes, [](const Ring& hole) { return hole.size() < 3 || signed_area_m2(hole) == 0; });
  if (result.shell.size() < 3) return {};
  start_west(result.shell);
  for (Ring& hole : result.holes) start_west(hole);
  std::sort(result.holes.begin(), result.holes.end(), [](const Ring& a, const Ring& b) {
    return a[0].x_m != b[0].x_m ? a[0].x_m < b[0].x_m : a[0].y_m < b[0].y_m;
  });
  return result;
}

}  // namespace selion
