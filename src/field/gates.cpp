// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "clean.hpp"
#include "selion/core/format.hpp"
#include "text.hpp"

namespace selion {
namespace {

struct OnBorder {
  double away_m = std::numeric_limits<double>::infinity();
  Point at;
  double inward_rad = 0;
};

/// The nearest place on the ring; at a corner the way in halves the angle between its edges.
OnBorder nearest(const Ring& ring, Point p) {
  OnBorder best;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % n];
    const Point along = b - a;
    const double share = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    const Point at = a + share * along;
    const double away_m = distance_m(at, p);
    if (away_m >= best.away_m) continue;
    Point direction = (1 / length_m(along)) * along;
    if (share == 1) {
      const Point next = ring[(i + 2) % n] - b;
      direction = direction + (1 / length_m(next)) * next;
    } else if (share == 0) {
      const Point before = a - ring[(i + n - 1) % n];
      direction = direction + (1 / length_m(before)) * before;
    }
    best = {away_m, at, heading_rad(left_of(direction))};
  }
  return best;
}

}  // namespace

void attach_gates(const Field& field, const LocalFrame& frame, Blocks& into) {
  constexpr double kReach_m = 20;
  for (const Gate& gate : field.gates) {
    const Point p = frame.to_local(gate.at);
    OnBorder best;
    Block* owner = nullptr;
    for (Block& block : into.blocks) {
      const OnBorder here = nearest(block.area.shell, p);
      if (here.away_m >= best.away_m) continue;
      best = here;
      owner = &block;
    }
    if (owner != nullptr && best.away_m <= kReach_m)
      owner->gates.push_back({gate.name, best.at, best.inward_rad, gate.width_m, 0});
    else
      into.notes.push_back(field.source + ": the gate '" + gate.name + "' at " + place(gate.at) +
                           " is left out, being " + fixed(best.away_m, 1) +
                           " m from the border; a gate must lie within 20 m of it");
  }
  int number = 0;
  for (Block& block : into.blocks)
    for (BlockGate& gate : block.gates) gate.number = ++number;
}

}  // namespace selion
