// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include "plan/coverage.hpp"

using namespace selion;

TEST_CASE("ground that one headland pass works again counts as worked twice", "[plan][coverage]") {
  Machine machine;
  machine.working_width_m = 3;
  machine.tool_x_m = 0;
  Block block;
  block.area = {{{-5, -5}, {35, -5}, {35, 5}, {-5, 5}}, {}};
  block.free = block.area;
  Layout layout;
  Route route;
  route.pieces = {{PieceKind::headland_pass,
                   "H1",
                   {{line({0, 0}, {30, 0}), Gear::forward}, {line({30, 0}, {10, 0}), Gear::forward}}}};

  const Coverage coverage = coverage_of(block, layout, route, machine);

  CHECK(coverage.covered_m2 == Approx(30 * 3));
  CHECK(coverage.twice.corners_m2 == Approx(20 * 3));
  CHECK(coverage.twice.total_m2() == Approx(20 * 3));
}
