// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "parts.hpp"

namespace selion {

AxisExtent extent_of(const Polygons& areas, Point axis) {
  AxisExtent out;
  for (const Polygon& area : areas)
    for (const Point p : area.shell) out.take(dot(p, axis));
  return out;
}

Ground ground_of(const Block& block, const Machine& machine, double edge_margin_m) {
  const Footprint footprint = footprint_of(machine);
  const Polygons edge = inset({Polygon{block.area.shell, {}}}, edge_margin_m);
  return {machine,
          footprint,
          free_space(block.free, footprint),
          intersect(edge, {block.free}),
          std::max(footprint.half_body_m, footprint.half_tool_m),
          edge_margin_m};
}

}  // namespace selion
