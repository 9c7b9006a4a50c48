// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/geometry/boolean.hpp"
#include "selion/layout/layout.hpp"
#include "selion/plan/plan.hpp"
#include "selion/route/route.hpp"

namespace selion {

/// What the tool sweeps while it is down, by the paths driven (not by the layout), within the block.
struct Coverage {
  double covered_m2 = 0;
  WorkedTwice twice;
  Polygons uncovered;  ///< largest first
};

Coverage coverage_of(const Block& block, const Layout& layout, const Route& route, const Machine& machine);

/// Of a machine that reached all that is laid out: no route covers more.
Coverage coverage_of_all(const Block& block, const Layout& layout, const Machine& machine);

}  // namespace selion
