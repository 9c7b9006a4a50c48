// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/layout/direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "selion/core/units.hpp"

namespace selion {
namespace {

constexpr double kPi = std::numbers::pi;

/// All edges as displacements turned into the upper half plane, angle in [0, pi).
struct UpperEdge {
  Point along;
  double angle_rad;
};

std::vector<UpperEdge> upper_edges(const Polygon& area) {
  std::vector<UpperEdge> edges;
  const auto take = [&edges](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      Point along = ring[i] - ring[j];
      if (length_m(along) == 0) continue;
      if (along.y_m < 0 || (along.y_m == 0 && along.x_m < 0)) along = -1 * along;
      edges.push_back({along, std::min(heading_rad(along), std::nextafter(kPi, 0))});
    }
  };
  take(area.shell);
  for (const Ring& hole : area.holes) take(hole);
  return edges;
}

/// Does every line along y meet the ring in one span? Then x turns back exactly twice.
bool monotone_in_x(const Ring& ring) {
  int turns = 0;
  int last = 0;
  int first = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    constexpr double kLevel_m = 1e-9;  // rounding of the rotation
    const double step = ring[i].x_m - ring[j].x_m;
    const int sign = step > kLevel_m ? 1 : step < -kLevel_m ? -1 : 0;
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++turns;
    if (first == 0) first = sign;
    last = sign;
  }
  if (first != last) ++turns;
  return turns <= 2;
}

Ring rotated(const Ring& ring, double by_rad) {
  const Point x = unit(by_rad);
  Ring out;
  out.reserve(ring.size());
  for (const Point p : ring) out.push_back(p.x_m * x + p.y_m * left_of(x));
  return out;
}

}  // namespace

DrivingDirection DrivingDirection::radians(double anticlockwise_from_east_rad) {
  DrivingDirection direction;
  const double rest = std::fmod(anticlockwise_from_east_rad, kPi);
  direction.radians_ = rest < 0 ? rest + kPi : rest;
  if (direction.radians_ >= kPi) direction.radians_ = 0;
  return direction;
}

DrivingDirection DrivingDirection::bearing_deg(double clockwise_from_north_deg) {
  return radians(radians_of_degrees(90 - clockwise_from_north_deg));
}

double DrivingDirection::bearing_deg() const {
  const double bearing = std::fmod(270 - degrees_of_radians(radians_), 180.0);
  return bearing >= 180 ? 0 : bearing;
}

double expected_pieces(const Polygon& area, DrivingDirection along, double spacing_m) {
  const Point direction = unit(along.radians());
  double sum = 0;
  for (const UpperEdge& edge : upper_edges(area)) sum += std::abs(cross(edge.along, direction));
  return sum / (2 * spacing_m);
}

DrivingDirection best_edge_direction(const Polygon& area) {
  std::vector<UpperEdge> edges = upper_edges(area);
  std::sort(edges.begin(), edges.end(), [](const UpperEdge& a, const UpperEdge& b) {
    return a.angle_rad < b.angle_rad || (a.angle_rad == b.angle_rad && length_m(a.along) > length_m(b.along));
  });
  Point below;  // sum of the edges at smaller angles than the one looked at: those cross it to the left
  Point above;
  for (const UpperEdge& edge : edges) above = above + edge.along;
  const UpperEdge* best = nullptr;
  double least_m = std::numeric_limits<double>::infinity();
  for (const UpperEdge& edge : edges) {
    below = below + edge.along;
    above = above - edge.along;
    const Point direction = (1 / length_m(edge.along)) * edge.along;
    const double across_m = cross(below, direction) - cross(above, direction);
    const double level_m = 1e-9 * (1 + std::abs(across_m));  // equal but for rounding: the longer edge wins
    const bool better = across_m < least_m - level_m || (across_m < least_m + level_m && best != nullptr &&
                                                         length_m(edge.along) > length_m(best->along) + 1e-6);
    if (!better) continue;
    least_m = std::min(least_m, across_m);
    best = &edge;
  }
  return best == nullptr ? DrivingDirection{} : DrivingDirection::radians(best->angle_rad);
}

Result<P3Direction> p3_direction(const Polygon& area) {
  if (!area.holes.empty())
    return Infeasible{"direction p3 knows no holes: every line across one leaves and re-enters the field"};
  P3Direction best;
  best.box_m2 = std::numeric_limits<double>::infinity();
  for (int rotation = 1; rotation <= 180; ++rotation) {
    const Ring turned = rotated(area.shell, radians_of_degrees(rotation));
    const Box box = bounds(turned);
    const Point size = box.high - box.low;
    if (size.y_m < size.x_m || !monotone_in_x(turned)) continue;
    const double box_m2 = size.x_m * size.y_m;
    if (box_m2 >= best.box_m2) continue;
    best = {DrivingDirection::radians(radians_of_degrees(90 - rotation)), static_cast<double>(rotation),
            box_m2};
  }
  if (!std::isfinite(best.box_m2))
    return Infeasible{
        "direction p3 finds no heading without a gap along the swaths: the field is too concave; use "
        "direction edge"};
  return best;
}

}  // namespace selion
