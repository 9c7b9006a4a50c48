// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include "selion/geometry/boolean.hpp"

using namespace selion;

namespace {

Polygon square(double side_m) { return {{{0, 0}, {side_m, 0}, {side_m, side_m}, {0, side_m}}, {}}; }

}  // namespace

TEST_CASE("an inset square keeps its corners sharp", "[geometry]") {
  const Polygons smaller = inset({square(10)}, 1);
  REQUIRE(smaller.size() == 1);
  CHECK(area_m2(smaller) == Approx(64));
}

TEST_CASE("an inset splits a field at its waist, largest part first", "[geometry]") {
  const Polygon waist{{{0, 0},
                       {10, 0},
                       {10, 4},
                       {14, 4},
                       {14, 0},
                       {30, 0},
                       {30, 10},
                       {14, 10},
                       {14, 6},
                       {10, 6},
                       {10, 10},
                       {0, 10}},
                      {}};
  const Polygons parts = inset({waist}, 1.5);
  REQUIRE(parts.size() == 2);
  CHECK(area_m2(parts[0]) > area_m2(parts[1]));
}

TEST_CASE("a segment through a hole is inside in two spans, in order", "[geometry]") {
  Polygon field = square(10);
  field.holes.push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  const auto spans = inside_spans({-5, 5}, {15, 5}, {field});
  REQUIRE(spans.size() == 2);
  CHECK(spans[0].from_m == Approx(5));
  CHECK(spans[0].to_m == Approx(9));
  CHECK(spans[1].from_m == Approx(11));
}
