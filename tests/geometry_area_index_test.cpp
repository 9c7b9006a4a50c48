// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <random>

#include "selion/geometry/area_index.hpp"
#include "selion/geometry/boolean.hpp"

using namespace selion;

namespace {

/// On a coarse lattice, so that rays run through corners and along edges, and points lie on borders.
std::vector<Polygon> lattice_areas() {
  const Polygon comb{{{0, 0}, {12, 0}, {12, 5}, {10, 5}, {10, 2}, {8, 2}, {8, 5}, {0, 5}},
                     {{{2, 1}, {2, 3}, {3, 3}, {3, 2}, {5, 2}, {5, 1}}}};
  const Polygon kite{{{16, -4}, {20, 1}, {16, 6}, {14, 1}}, {}};
  return {comb, kite};
}

bool contained(const std::vector<Polygon>& areas, Point p) {
  return std::any_of(areas.begin(), areas.end(), [p](const Polygon& area) { return contains(area, p); });
}

}  // namespace

TEST_CASE("an index of areas answers as the areas do", "[geometry]") {
  const std::vector<Polygon> areas = lattice_areas();
  const AreaIndex index{areas};
  for (int x = -4; x <= 44; ++x)
    for (int y = -12; y <= 16; ++y) {
      const Point p{x / 2.0, y / 2.0};
      CAPTURE(p.x_m, p.y_m);
      REQUIRE(index.holds(p) == contained(areas, p));
    }
  std::mt19937 random{1};  // NOLINT(cert-msc51-cpp): the same points every time
  std::uniform_real_distribution<double> x{-2, 22};
  std::uniform_real_distribution<double> y{-6, 8};
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point p{x(random), y(random)};
    REQUIRE(index.holds(p) == contained(areas, p));
    inside += index.holds(p) ? 1 : 0;
  }
  CHECK(inside > 3000);
  CHECK_FALSE(AreaIndex{{}}.holds({0, 0}));
}

TEST_CASE("many areas are united as few are", "[geometry]") {
  std::vector<Polygon> strips;
  for (int i = 0; i < 500; ++i) {
    const double x = 0.7 * i;
    strips.push_back({{{x, 0}, {x + 0.7, 0}, {x + 0.7, 3}, {x, 3}}, {}});
  }
  const Polygons whole = unite(strips);
  REQUIRE(whole.size() == 1);
  CHECK(whole.front().holes.empty());
  CHECK(area_m2(whole) == Approx(350 * 3));
}
