// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/geometry/boolean.hpp"

#include <algorithm>
#include <cmath>

#include <polyclipping/clipper.hpp>

namespace selion {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Paths;

constexpr double kGrid_per_m =
    1e6;  // 1 um: a thousandth of the finest tolerance that anything here is held to
constexpr double kLeastPart_m2 = 1e-6;  // what rounding to the grid can leave behind
constexpr std::size_t kUnitedAtOnce = 32;
constexpr double kArcTolerance_m = 1e-3;

IntPoint to_grid(Point p) {
  return {static_cast<cInt>(std::llround(p.x_m * kGrid_per_m)),
          static_cast<cInt>(std::llround(p.y_m * kGrid_per_m))};
}

Point from_grid(IntPoint p) {
  return {static_cast<double>(p.X) / kGrid_per_m, static_cast<double>(p.Y) / kGrid_per_m};
}

ClipperLib::Path to_grid(const std::vector<Point>& points) {
  ClipperLib::Path path;
  path.reserve(points.size());
  for (const Point p : points) path.push_back(to_grid(p));
  return path;
}

/// With shells anticlockwise and holes clockwise, whatever way round they came.
Paths to_grid(const Polygons& areas) {
  Paths paths;
  const auto add = [&paths](const Ring& ring, bool anticlockwise) {
    paths.push_back(to_grid(ring));
    if (ClipperLib::Orientation(paths.back()) != anticlockwise) ClipperLib::ReversePath(paths.back());
  };
  for (const Polygon& area : areas) {
    add(area.shell, true);
    for (const Ring& hole : area.holes) add(hole, false);
  }
  return paths;
}

Ring from_grid(const ClipperLib::Path& path) {
  Ring ring;
  ring.reserve(path.size());
  for (const IntPoint p : path) ring.push_back(from_grid(p));
  return ring;
}

void collect(const ClipperLib::PolyNode& node, Polygons& into) {
  for (const ClipperLib::PolyNode* shell : node.Childs) {
    Polygon area{from_grid(shell->Contour), {}};
    for (const ClipperLib::PolyNode* hole : shell->Childs) {
      area.holes.push_back(from_grid(hole->Contour));
      collect(*hole, into);
    }
    if (area_m2(area) >= kLeastPart_m2) into.push_back(std::move(area));
  }
}

/// Anticlockwise shells, clockwise holes, largest first; equal areas in order of their lowest corner, so that
/// the order never hangs on how the sweep went.
Polygons from_grid(const ClipperLib::PolyTree& tree) {
  Polygons areas;
  collect(tree, areas);
  for (Polygon& area : areas) {
    if (signed_area_m2(area.shell) < 0) std::reverse(area.shell.begin(), area.shell.end());
    for (Ring& hole : area.holes)
      if (signed_area_m2(hole) > 0) std::reverse(hole.begin(), hole.end());
  }
  std::stable_sort(areas.begin(), areas.end(),
                   [](const Polygon& a, const Polygon& b) { return area_m2(a) > area_m2(b); });
  return areas;
}

Polygons combined(ClipperLib::ClipType what, const Paths& subject, const Paths& clip) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(what, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return from_grid(tree);
}

Polygons moved_border(const Polygons& areas, double by_m, ClipperLib::JoinType join, double miter_limit) {
  ClipperLib::ClipperOffset offset{miter_limit, kArcTolerance_m * kGrid_per_m};
  offset.AddPaths(to_grid(areas), join, ClipperLib::etClosedPolygon);
  ClipperLib::PolyTree tree;
  offset.Execute(tree, by_m * kGrid_per_m);
  return from_grid(tree);
}

}  // namespace

/// Many in halves: Clipper's time grows with the square of what touches.
Polygons unite(const Polygons& areas) {
  if (areas.size() <= kUnitedAtOnce) return combined(ClipperLib::ctUnion, to_grid(areas), {});
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  Polygons halves = unite(Polygons(areas.begin(), middle));
  const Polygons rest = unite(Polygons(middle, areas.end()));
  halves.insert(halves.end(), rest.begin(), rest.end());
  return combined(ClipperLib::ctUnion, to_grid(halves), {});
}

Polygons intersect(const Polygons& a, const Polygons& b) {
  return combined(ClipperLib::ctIntersection, to_grid(a), to_grid(b));
}

Polygons subtract(const Polygons& a, const Polygons& b) {
  return combined(ClipperLib::ctDifference, to_grid(a), to_grid(b));
}

Polygons turned(Polygons areas, double by_rad) {
  const Point x = unit(by_rad);
  const Point y = left_of(x);
  const auto turn = [&](Ring& ring) {
    for (Point& p : ring) p = p.x_m * x + p.y_m * y;
  };
  for (Polygon& area : areas) {
    turn(area.shell);
    for (Ring& hole : area.holes) turn(hole);
  }
  return areas;
}

Polygons inset(const Polygons& areas, double distance_m) {
  constexpr double kSharpest = 20;  // corners down to 6 degrees stay sharp
  return moved_border(areas, -distance_m, ClipperLib::jtMiter, kSharpest);
}

Polygons inset_round(const Polygons& areas, double distance_m) {
  return moved_border(areas, -distance_m, ClipperLib::jtRound, 2);
}

Polygons outset_round(const Polygons& areas, double distance_m) {
  return moved_border(areas, distance_m, ClipperLib::jtRound, 2);
}

Polygons outset(const Polygons& areas, double distance_m, double miter_limit) {
  return moved_border(areas, distance_m, ClipperLib::jtMiter, miter_limit);
}

Polygons band(const std::vector<Point>& line, double width_m) {
  ClipperLib::ClipperOffset offset{2, kArcTolerance_m * kGrid_per_m};
  offset.AddPath(to_grid(line), ClipperLib::jtRound, ClipperLib::etOpenButt);
  ClipperLib::PolyTree tree;
  offset.Execute(tree, width_m / 2 * kGrid_per_m);
  return from_grid(tree);
}

std::vector<Span1> inside_spans(Point a, Point b, const Polygons& areas) {
  ClipperLib::Clipper clipper;
  clipper.AddPath({to_grid(a), to_grid(b)}, ClipperLib::ptSubject, false);
  clipper.AddPaths(to_grid(areas), ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  Paths pieces;
  ClipperLib::OpenPathsFromPolyTree(tree, pieces);
  const Point along = (1 / distance_m(a, b)) * (b - a);
  std::vector<Span1> spans;
  for (const ClipperLib::Path& piece : pieces) {
    const double s = dot(from_grid(piece.front()) - a, along);
    const double e = dot(from_grid(piece.back()) - a, along);
    spans.push_back({std::min(s, e), std::max(s, e)});
  }
  std::sort(spans.begin(), spans.end(), [](const Span1& p, const Span1& q) { return p.from_m < q.from_m; });
  return spans;
}

}  // namespace selion
