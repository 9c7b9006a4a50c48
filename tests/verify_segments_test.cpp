// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "verify/border.hpp"

using namespace selion;
using namespace selion::verifying;

namespace {

/// Around the origin, with `corners` corners and no two borders alike.
std::vector<Point> star(std::size_t corners, std::mt19937& random) {
  std::uniform_real_distribution<double> radius{5, 30};
  std::vector<Point> ring;
  for (std::size_t i = 0; i < corners; ++i)
    ring.push_back(radius(random) * unit(6.28 * static_cast<double>(i) / static_cast<double>(corners)));
  return ring;
}

Corners some_rectangle(std::mt19937& random) {
  std::uniform_real_distribution<double> place{-30, 30};
  std::uniform_real_distribution<double> side{0, 4};
  const Point at{place(random), place(random)};
  const Point ahead = unit(place(random));
  const Point length = side(random) * ahead;
  const Point width = side(random) * left_of(ahead);
  return {at, at + length, at + length + width, at + width};
}

}  // namespace

TEST_CASE("a rectangle that is clear of a border does not touch it", "[verify][segments]") {
  std::mt19937 random{7};
  const Shape border = border_of(polygon_of(star(GENERATE(3, 4, 5, 17, 200), random)));
  const Prepared prepared{border};
  const Segments segments{lines_of(border)};
  int clear = 0;
  int free = 0;
  for (int i = 0; i < 2000; ++i) {
    const Corners rectangle = some_rectangle(random);
    const bool touches = prepared.touches(rectangle);
    if (!touches) ++free;
    if (!segments.clear_of(rectangle)) continue;
    ++clear;
    CHECK_FALSE(touches);
  }
  CHECK(clear == free);  // a micrometre is too little to be met by chance
}

TEST_CASE("nothing is clear of no border, or by numbers that are none", "[verify][segments]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Corners square{Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}};
  const Segments far{{{{9, 9}, {9, 10}}}};
  CHECK(far.clear_of(square));
  CHECK_FALSE(far.clear_of({Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, none}}));
  CHECK_FALSE(Segments{{}}.clear_of(square));
  CHECK_FALSE(Segments{{{{9, 9}, {9, none}}}}.clear_of(square));
  CHECK_FALSE(far.clear_of({Point{8, 9}, Point{9 - 1e-7, 9}, Point{9 - 1e-7, 10}, Point{8, 10}}));
  CHECK(std::isinf(far.farthest_m(std::vector{Point{0, none}})));
  CHECK(std::isinf(Segments{{}}.farthest_m(square)));
}

TEST_CASE("the farthest place is as far as GEOS says", "[verify][segments]") {
  std::mt19937 random{11};
  const std::vector<Point> line = star(GENERATE(1, 2, 3, 9, 100), random);
  const std::vector<Point> places = star(150, random);
  double most = 0;
  for (const Point p : places) {
    if (line.size() == 1) {
      most = std::max(most, selion::distance_m(p, line[0]));
    } else {
      most = std::max(most, Prepared{line_through(line)}.distance_m(std::array{p}));
    }
  }
  CHECK(Segments{{line}}.farthest_m(places) == Approx(most).epsilon(1e-12));
}

TEST_CASE("rectangles and lines lie as far apart as GEOS says", "[verify][segments]") {
  std::mt19937 random{17};
  for (int i = 0; i < 3000; ++i) {
    const Corners a = some_rectangle(random);
    Corners b = some_rectangle(random);
    if (i % 3 == 0) b[1] = b[0], b[2] = b[3];  // flat
    const Shape flat = i % 3 == 0 ? line_through(std::array{b[0], b[2]}) : polygon_of(b);
    CHECK(distance_m(a, b) == Approx(distance_m(polygon_of(a), flat)).margin(1e-9));
    CHECK(distance_m(b, a) == distance_m(a, b));
  }
}

TEST_CASE("a tangle is known by what crosses, and by what lies abreast", "[verify][segments]") {
  std::vector<Point> zigzag;  // between two slanted lines, nowhere across itself
  for (int k = 0; k < 100; ++k) zigzag.push_back({0.1 * k + (k % 2) * 50, (k % 2) * 50.0});
  CHECK_FALSE(Segments{{zigzag}}.tangled(0, 99 * 98 / 2));
  CHECK(Segments{{zigzag}}.tangled(0, 99 * 98 / 2 - 1));
  std::vector<Point> star;  // each of its five sides crosses two others
  for (int k = 0; k <= 5; ++k) star.push_back(unit(2 * 6.283185307 / 5 * (k % 5)));
  CHECK_FALSE(Segments{{star}}.tangled(5, 100));
  CHECK(Segments{{star}}.tangled(4, 100));
  CHECK_FALSE(Segments{{}}.tangled(0, 0));
}

TEST_CASE("polygons dissolved are those united", "[verify][segments]") {
  std::mt19937 random{13};
  std::vector<Shape> shapes;
  shapes.reserve(65);
  for (int i = 0; i < 60; ++i) shapes.push_back(polygon_of(some_rectangle(random)));
  for (int i = 0; i < 5; ++i) shapes.push_back(polygon_of(star(40, random)));
  const Shape all = dissolved(shapes);
  CHECK(is_valid(all));
  CHECK(area_m2(all) == Approx(area_m2(united(shapes))).epsilon(1e-12));
}
