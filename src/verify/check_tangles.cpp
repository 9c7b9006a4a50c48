// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr int kMost = 1000;  // crossings; rounding leaves a few where a border all but touches itself

struct Edge {
  Point a;  ///< the western end
  Point b;
};

std::vector<Edge> edges_of(const std::vector<std::vector<Point>>& rings) {
  std::vector<Edge> edges;
  for (const std::vector<Point>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      edges.push_back(a.x_m < b.x_m ? Edge{a, b} : Edge{b, a});
    }
  std::ranges::sort(edges, {}, [](const Edge& e) { return e.a.x_m; });
  return edges;
}

bool cross_each_other(const Edge& e, const Edge& f) {
  const auto apart = [](const Edge& line, const Edge& other) {
    const double a = cross(line.b - line.a, other.a - line.a);
    const double b = cross(line.b - line.a, other.b - line.a);
    return (a < 0 && b > 0) || (a > 0 && b < 0);
  };
  return apart(e, f) && apart(f, e);
}

bool cross_often(const std::vector<Edge>& edges) {
  int crossings = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = i + 1; k < edges.size() && edges[k].a.x_m <= edges[i].b.x_m; ++k)
      if (cross_each_other(edges[i], edges[k]) && ++crossings > kMost) return true;
  return false;
}

/// Does its border cross itself so often that it encloses nothing in particular? To sort that out takes long.
bool is_tangle(const Plane& plane, const LonLatArea& area) {
  Outline outline{plane.to_local(area.shell), {}};
  for (const LonLatLine& hole : area.holes) outline.holes.push_back(plane.to_local(hole));
  std::vector<std::vector<Point>> rings = outline.holes;
  rings.push_back(outline.shell);
  for (const std::vector<Point>& ring : rings)
    for (const Point p : ring)
      if (!std::isfinite(p.x_m) || !std::isfinite(p.y_m)) return true;
  return !is_valid(polygon_of(outline)) && cross_often(edges_of(rings));
}

bool check_parts(Case& plan, int block, const std::vector<LonLatArea>& parts, const std::string& what) {
  bool sound = true;
  for (const LonLatArea& part : parts) {
    if (!is_tangle(plan.plane, part)) continue;
    plan.findings.add("field_shape", block, plan.plane.to_local(part.shell.front()), {0, kMost},
                      what + " crosses itself more than " + std::to_string(kMost) +
                          " times, or lies nowhere; the plan is not checked further");
    sound = false;
  }
  return sound;
}

}  // namespace

bool check_tangles(Case& plan) {
  const PlanFile& file = plan.plan;
  bool sound = true;
  for (const FieldRecord& field : file.fields)
    sound = check_parts(plan, 0, field.parts, "the border of the field") && sound;
  for (const ObstacleRecord& obstacle : file.obstacles)
    sound = check_parts(plan, obstacle.block, {obstacle.area}, "the border of an obstacle") && sound;
  for (const HeadlandRecord& headland : file.headlands)
    sound = check_parts(plan, headland.block, headland.parts, "the border of the headland") && sound;
  for (const CellRecord& cell : file.cells)
    sound = check_parts(plan, cell.block, cell.parts, "the border of a cell") && sound;
  return sound;
}

}  // namespace selion::verifying
