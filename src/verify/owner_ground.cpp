// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_ground.hpp"

#include <algorithm>
#include <cmath>

namespace selion::verifying {
namespace {

/// How often the ring goes round `p`, anticlockwise.
int turns_around(Point p, const std::vector<Point>& ring) {
  int turns = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[j];
    const Point b = ring[i];
    if ((a.y_m <= p.y_m) == (b.y_m <= p.y_m)) continue;
    const bool on_the_left = cross(b - a, p - a) > 0;
    if (b.y_m > p.y_m && on_the_left) ++turns;
    if (b.y_m <= p.y_m && !on_the_left) --turns;
  }
  return turns;
}

enum class Island {
  left_out,  ///< what the ring goes round and back again, a bridge leading to it, is no part of it
  taken      ///< as of holes: all that it encloses
};

/// What a ring encloses; even where it crosses itself.
Shape enclosed(std::vector<Point> ring, Island island) {
  const bool finite =
      std::ranges::all_of(ring, [](Point p) { return std::isfinite(p.x_m) && std::isfinite(p.y_m); });
  if (ring.size() < 3 || !finite) return united({});
  if (Shape plain = polygon_of(ring); is_valid(plain)) return plain;
  ring.push_back(ring.front());
  std::vector<Shape> faces;
  for (Shape& face : faces_of(line_through(ring)))
    if (const auto p = place_in(face); p && (island == Island::taken || turns_around(*p, ring) != 0))
      faces.push_back(std::move(face));
  return united(faces);
}

/// Stretches of straight band, and round corners between them: nothing beyond its ends.
void add_band(std::vector<Shape>& shapes, const std::vector<Point>& line, double width_m) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point along = line[i] - line[i - 1];
    if (!(length_m(along) > 0)) continue;
    const Point aside = (width_m / 2 / length_m(along)) * left_of(along);
    shapes.push_back(polygon_of(
        std::vector<Point>{line[i - 1] + aside, line[i - 1] - aside, line[i] - aside, line[i] + aside}));
    if (i > 1) shapes.push_back(grown(place_at(line[i - 1]), width_m / 2));
  }
}

}  // namespace

OwnerGround ground_of(const Plane& plane, const OwnerFeature& feature) {
  std::vector<Shape> areas;
  std::vector<Shape> holes;
  for (const LonLatArea& part : feature.parts) {
    const Shape shell = enclosed(plane.to_local(part.shell), Island::left_out);
    std::vector<Shape> off;
    for (const LonLatLine& hole : part.holes) off.push_back(enclosed(plane.to_local(hole), Island::taken));
    areas.push_back(off.empty() ? shell : without(shell, united(off)));
    holes.insert(holes.end(), off.begin(), off.end());
  }
  OwnerGround ground{united(areas), nullptr};
  ground.holes = without(united(holes), ground.area);  // a part may lie in another one's hole
  return ground;
}

Shape obstacle_of(const Plane& plane, const OwnerFeature& feature) {
  constexpr double kLine_m = 0.02;
  std::vector<Shape> shapes{ground_of(plane, feature).area};
  for (const LonLatLine& line : feature.lines)
    add_band(shapes, plane.to_local(line), feature.width_m.value_or(kLine_m));
  for (const Point p : plane.to_local(feature.points))
    shapes.push_back(grown(place_at(p), feature.radius_m.value_or(0)));
  return united(shapes);
}

}  // namespace selion::verifying
