// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/field/field.hpp"
#include "selion/geometry/polygon.hpp"

namespace selion {

struct GeneratedField {
  std::string name;  ///< "star 3": its shape and number, for messages
  Polygon area;      ///< in metres around (0, 0); shells anticlockwise, holes clockwise
};

/// Stars, L shapes, combs, fields with slanted headlands and fields with one or two holes, `count_of_each` of
/// each, 1 to 4 ha, turned by any angle. The same on every machine. None is like itself when turned or
/// mirrored, so that no two directions are equally good.
std::vector<GeneratedField> generated_fields(int count_of_each);

/// The place farthest from every border, to a few metres.
Point deepest_place(const Polygon& area);

/// `p` turned by `angle_rad` around (0, 0), then moved by `by`.
struct RigidMotion {
  double angle_rad = 0;
  Point by;

  [[nodiscard]] Point operator()(Point p) const;
};

/// Every corner put through `move`, any function from Point to Point; rings stay in their order.
template <class Move>
Polygon moved(const Polygon& area, const Move& move);

}  // namespace selion

template <class Move>
selion::Polygon selion::moved(const Polygon& area, const Move& move) {
  const auto ring = [&move](const Ring& corners) {
    Ring result;
    for (const Point p : corners) result.push_back(move(p));
    return result;
  };
  Polygon result{ring(area.shell), {}};
  for (const Ring& hole : area.holes) result.holes.push_back(ring(hole));
  return result;
}
