// SPDX-License-Identifier: GPL-3.0-or-later
#include "swept_ground.hpp"

#include <algorithm>
#include <utility>

namespace selion {
namespace {

bool apart(const Box& a, const Box& b) {
  return a.high.x_m < b.low.x_m || b.high.x_m < a.low.x_m || a.high.y_m < b.low.y_m || b.high.y_m < a.low.y_m;
}

}  // namespace

Polygons swept_by(const Footprint& footprint, const Path& path) {
  Polygons swept;
  for (Ring& ring : swept_by_tool(footprint, path)) swept.push_back({std::move(ring), {}});
  return swept;
}

void SweptGround::add(const Path& path, std::size_t whose) {
  for (Ring& ring : swept_by_tool(footprint_, path)) add(std::move(ring), whose);
}

void SweptGround::add(Ring ring, std::size_t whose) {
  const Box box = bounds(ring);
  strips_.push_back({std::move(ring), box, whose});
}

void SweptGround::remove(std::size_t whose) {
  std::erase_if(strips_, [whose](const Strip& strip) { return strip.whose == whose; });
}

Polygons SweptGround::swept_only_by(std::size_t whose, const Polygons& workable) const {
  Polygons own;
  Polygons others;
  for (const Strip& strip : strips_)
    if (strip.whose == whose) own.push_back({strip.ring, {}});
  for (const Strip& strip : strips_) {
    const auto touches = [&](const Polygon& part) { return !apart(bounds(part.shell), strip.box); };
    if (strip.whose != whose && std::any_of(own.begin(), own.end(), touches))
      others.push_back({strip.ring, {}});
  }
  return subtract(intersect(unite(own), workable), others);
}

}  // namespace selion
