// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/field/block.hpp"
#include "selion/geometry/boolean.hpp"

namespace selion {

/// A field's parts as sets of places.
struct Cleaned {
  Polygons parts;  ///< disjoint, holes taken off, largest first
  Polygons holes;  ///< what was taken off, overlaps and all, and gaps that parts enclose
  std::vector<std::string> notes;
};

/// @throws InputError naming part, ring and place where a repair would move a border by more than 1 cm or
/// change the area by more than 0.1 %, unless `repair` accepts that; and where no area is left.
Cleaned cleaned(const Field& field, const LocalFrame& frame, Repair repair);

/// Whether nothing of `areas` is wider than 1 cm.
bool is_sliver(const Polygons& areas);

/// Without edges below 1 mm and spikes; anticlockwise shell, clockwise holes, each from its westernmost
/// corner. Empty where nothing is left.
Polygon tidied(const Polygon& area);

Ring local_ring(const LonLatRing& ring, const LocalFrame& frame, const std::string& where);

/// Gives each gate to the block whose border is nearest, if that is within 20 m.
void attach_gates(const Field& field, const LocalFrame& frame, Blocks& into);

}  // namespace selion
