// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "crossing.hpp"

namespace selion {
namespace {

enum class Side { outside, border, inside };

Side side_of(const Ring& ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const RayMeets meets = ray_meets(ring[j], ring[i], p);
    if (meets == RayMeets::the_edge_at_p) return Side::border;
    if (meets == RayMeets::crossing) inside = !inside;
  }
  return inside ? Side::inside : Side::outside;
}

}  // namespace

double signed_area_m2(const Ring& ring) {
  if (ring.empty()) return 0;
  double twice = 0;
  const Point origin =
      ring.front();  // differences keep the digits of a small field far from its frame's origin
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    twice += cross(ring[j] - origin, ring[i] - origin);
  return twice / 2;
}

double perimeter_m(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) sum += distance_m(ring[j], ring[i]);
  return sum;
}

double perimeter_m(const Polygon& area) {
  double sum = perimeter_m(area.shell);
  for (const Ring& hole : area.holes) sum += perimeter_m(hole);
  return sum;
}

double area_m2(const Polygon& area) {
  double sum = std::abs(signed_area_m2(area.shell));
  for (const Ring& hole : area.holes) sum -= std::abs(signed_area_m2(hole));
  return sum;
}

double area_m2(const std::vector<Polygon>& areas) {
  double sum = 0;
  for (const Polygon& area : areas) sum += area_m2(area);
  return sum;
}

Point centroid(const Polygon& area) {
  const Point origin = area.shell.empty() ? Point{} : area.shell.front();
  Point moment;
  double twice = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Point a = ring[j] - origin;
      const Point b = ring[i] - origin;
      moment = moment + cross(a, b) * (a + b);
      twice += cross(a, b);
    }
  };
  add(area.shell);
  for (const Ring& hole : area.holes) add(hole);
  if (twice != 0) return origin + (1 / (3 * twice)) * moment;
  Point mean;
  for (const Point p : area.shell) mean = mean + (1.0 / static_cast<double>(area.shell.size())) * p;
  return mean;
}

bool contains(const Ring& ring, Point p) { return !ring.empty() && side_of(ring, p) != Side::outside; }

bool contains(const Polygon& area, Point p) {
  return contains(area.shell, p) && std::none_of(area.holes.begin(), area.holes.end(), [p](const Ring& hole) {
           return side_of(hole, p) == Side::inside;
         });
}

Ring convex_hull(Ring points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x_m < b.x_m || (a.x_m == b.x_m && a.y_m < b.y_m); });
  Ring hull;
  hull.reserve(points.size() + 2);
  for (int side = 0; side < 2; ++side) {
    const std::size_t floor = hull.size() + 1;
    for (const Point p : points) {
      while (hull.size() > floor && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Box bounds(const Ring& ring) {
  const double inf = std::numeric_limits<double>::infinity();
  Box box{{inf, inf}, {-inf, -inf}};
  for (const Point p : ring) {
    box.low = {std::min(box.low.x_m, p.x_m), std::min(box.low.y_m, p.y_m)};
    box.high = {std::max(box.high.x_m, p.x_m), std::max(box.high.y_m, p.y_m)};
  }
  return box;
}

bool meet(const Box& a, const Box& b) {
  return a.low.x_m <= b.high.x_m && b.low.x_m <= a.high.x_m && a.low.y_m <= b.high.y_m &&
         b.low.y_m <= a.high.y_m;
}

}  // namespace selion
