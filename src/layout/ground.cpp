// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "parts.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {

AxisExtent extent_of(const Polygons& areas, Point axis) {
  AxisExtent out;
  for (const Polygon& area : areas)
    for (const Point p : area.shell) out.take(dot(p, axis));
  return out;
}

namespace {

/// Where the tool is to work, by borders with no more corners than a machine can follow, and within the true
/// ones.
Polygons workable_in(const Block& block, double edge_margin_m) {
  const Evened border = evened({block.area.shell, {}});
  const Polygons edge = inset({border.area}, edge_margin_m + border.stray_m);
  const Evened free = evened(block.free);
  return intersect(edge, free.stray_m > 0 ? inset({free.area}, free.stray_m) : Polygons{free.area});
}

}  // namespace

Ground ground_of(const Block& block, const Machine& machine, double edge_margin_m, double border_room_m) {
  const Footprint footprint = footprint_of(machine);
  return {machine,
          footprint,
          free_space(block.free, footprint),
          workable_in(block, edge_margin_m),
          std::max(footprint.half_body_m, footprint.half_tool_m),
          edge_margin_m,
          border_room_m,
          Swings{limits_at(machine, machine.turn_speed_mps)}};
}

}  // namespace selion
