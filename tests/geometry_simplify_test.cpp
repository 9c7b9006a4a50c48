// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "selion/geometry/simplify.hpp"

using namespace selion;

namespace {

Ring circle(double radius_m, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) ring.push_back(radius_m * unit(2 * std::numbers::pi * i / corners));
  return ring;
}

double off_m(const Ring& ring, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point along = ring[i] - ring[j];
    const double t = std::clamp(dot(p - ring[j], along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, distance_m(p, ring[j] + t * along));
  }
  return least;
}

}  // namespace

TEST_CASE("an area whose corners lie a metre apart or more stays as it is", "[geometry]") {
  const Polygon area{circle(100, 600), {circle(20, 100)}};
  const Evened evened_area = evened(area);
  CHECK(evened_area.area == area);
  CHECK(evened_area.stray_m == 0);
}

TEST_CASE("a thousand and more corners are evened out where they lie closer than 3 m", "[geometry]") {
  Ring border = circle(600, 1800);
  for (std::size_t i = 0; i < border.size(); i += 2) border[i] = (1 + 0.02 / 600) * border[i];
  const Evened many = evened({border, {}});
  CHECK(many.area.shell.size() < 1260);
  CHECK(many.stray_m > 0.01);
  CHECK(many.stray_m <= 0.1);
  border.resize(900);  // half of it: as close, but few
  CHECK(evened({border, {}}).stray_m == 0);
}

TEST_CASE("corners close together are evened out by no more than is said", "[geometry]") {
  const Polygon area{circle(100, 6000), {circle(20, 1500)}};
  const Evened evened_area = evened(area);
  CHECK(evened_area.area.shell.size() < 630);
  CHECK(evened_area.stray_m > 0);
  CHECK(evened_area.stray_m <= 0.1);
  double worst_m = 0;
  for (const Point p : area.shell) worst_m = std::max(worst_m, off_m(evened_area.area.shell, p));
  for (const Point p : area.holes[0]) worst_m = std::max(worst_m, off_m(evened_area.area.holes[0], p));
  CHECK(worst_m > 0);
  CHECK(worst_m <= evened_area.stray_m);
}

TEST_CASE("a ring simplified to the left leaves none of its corners left of it", "[geometry]") {
  Ring wavy;  // anticlockwise: left is inside
  for (int i = 0; i < 400; ++i)
    wavy.push_back((100 + 0.15 * std::sin(23.0 * i)) * unit(2 * std::numbers::pi * i / 400));
  const Ring inside = simplified_to_left(wavy, 0.2);
  const Ring around = simplified_to_left({wavy.rbegin(), wavy.rend()}, 0.2);
  CHECK(inside.size() < wavy.size() / 3);
  for (const Point p : wavy) {
    CHECK((!contains(Polygon{inside, {}}, p) || off_m(inside, p) < 1e-9));
    CHECK((contains(Polygon{around, {}}, p) || off_m(around, p) < 1e-9));
    CHECK(off_m(inside, p) < 0.6);
    CHECK(off_m(around, p) < 0.6);
  }
}

TEST_CASE("a straight ring is simplified to the left without being moved", "[geometry]") {
  const Ring square{{0, 0}, {50, 0}, {100, 0}, {100, 100}, {0, 100}};
  CHECK(simplified_to_left(square, 0.1) == simplified(square, 0.1));
}
