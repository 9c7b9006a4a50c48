// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parts.hpp"

namespace selion {
namespace {

constexpr double kSliver_m = 0.1;  // gaps narrower than twice this are guidance error, not a pocket
// Least area worth a pass, in squares of the working width: one that may reverse backs out of a corner, one
// that may not has to come and go in a loop.
constexpr double kPassWorth = 0.75;
constexpr double kForwardPassWorth = 2;
constexpr double kLeastShare = 0.15;  // of the working width that a pass has to find unworked
constexpr double kLeastLength = 1.5;  // of the working width
constexpr int kRounds = 2;

/// The heading along which the part is narrowest across: one of its own edges' (Freeman and Shapira 1975).
double long_heading(const Polygon& part) {
  double best = 0;
  double least_m = std::numeric_limits<double>::infinity();
  const Ring& ring = part.shell;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (distance_m(ring[j], ring[i]) < kSliver_m) continue;
    const double heading = heading_rad(ring[i] - ring[j]);
    const Point side = left_of(unit(heading));
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point p : ring) low = std::min(low, dot(p, side)), high = std::max(high, dot(p, side));
    if (high - low < least_m - 1e-6) least_m = high - low, best = heading;
  }
  return best;
}

/// What of `part` lies under the strip a-b: parts closer than a width belong to one piece.
struct Find {
  AxisExtent along;
  double area_m2 = 0;
};
std::vector<Find> finds_under(const Polygon& part, Point a, Point b, double width_m) {
  const Point axis = (1 / distance_m(a, b)) * (b - a);
  std::vector<Find> finds;
  for (const Polygon& gained : intersect({part}, {Polygon{strip(a, b, width_m), {}}}))
    finds.push_back({extent_of({gained}, axis), area_m2(gained)});
  std::sort(finds.begin(), finds.end(),
            [](const Find& p, const Find& q) { return p.along.low_m < q.along.low_m; });
  std::vector<Find> merged;
  for (const Find& find : finds) {
    if (merged.empty() || find.along.low_m - merged.back().along.high_m > width_m) {
      merged.push_back(find);
      continue;
    }
    merged.back().along.take(find.along.high_m);
    merged.back().area_m2 += find.area_m2;
  }
  return merged;
}

double least_pocket_m2(const Machine& machine) {
  return (machine.may_reverse ? kPassWorth : kForwardPassWorth) * machine.working_width_m *
         machine.working_width_m;
}

bool worth_a_pass(const Find& find, const Machine& machine) {
  const double length = find.along.high_m - find.along.low_m;
  return length >= kSliver_m &&
         find.area_m2 >= std::max(least_pocket_m2(machine), kLeastShare * machine.working_width_m * length);
}

/// The runs that can be driven of a-b, which lies along `axis`.
std::vector<Swath> runs_of(const Ground& ground, Point a, Point b, Point axis) {
  std::vector<Swath> runs;
  for (const Span1& run : drivable_spans(ground, a, b))
    if (run.to_m - run.from_m > kSliver_m)
      runs.push_back({"", 0, a + run.from_m * axis, a + run.to_m * axis});
  return runs;
}

/// Straight strips over one part, spread evenly across it, each as long as what it finds there.
std::vector<Swath> pieces_over(const Ground& ground, const Polygon& part) {
  const double width = ground.machine.working_width_m;
  const Point axis = unit(long_heading(part));
  const Point side = left_of(axis);
  const AxisExtent along = extent_of({part}, axis);
  const AxisExtent across = extent_of({part}, side);
  const double span = across.high_m - across.low_m;
  const int count = std::max(1, static_cast<int>(std::ceil((span - kSliver_m) / width)));
  std::vector<Swath> pieces;
  for (int k = 0; k < count; ++k) {
    const double c = count == 1 ? (across.low_m + across.high_m) / 2
                                : across.low_m + width / 2 + (span - width) * k / (count - 1);
    const Point origin = c * side;
    for (const Find& find :
         finds_under(part, along.low_m * axis + origin, along.high_m * axis + origin, width)) {
      if (!worth_a_pass(find, ground.machine)) continue;
      const auto runs =
          runs_of(ground, find.along.low_m * axis + origin, find.along.high_m * axis + origin, axis);
      pieces.insert(pieces.end(), runs.begin(), runs.end());
    }
  }
  return pieces;
}

/// The longest run of the piece on which the machine fits, driven from its `from` side.
AxisExtent longest_fit(const Ground& ground, const Swath& piece) {
  constexpr double kStep_m = 0.25;
  const double length = distance_m(piece.from, piece.to);
  const Point axis = (1 / length) * (piece.to - piece.from);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep_m)));
  AxisExtent best{0, 0};
  std::optional<double> from;
  for (int k = 0; k <= steps; ++k) {
    const double s = length * k / steps;
    const Pose axle{piece.from + (s - ground.machine.tool_x_m) * axis, heading_rad(axis)};
    if (!fits(ground.space, ground.footprint, axle)) {
      from.reset();
      continue;
    }
    if (!from) from = s;
    if (s - *from > best.high_m - best.low_m + 1e-6) best = {*from, s};
  }
  return best;
}

/// As much of the piece as the machine fits on, driven one way or the other; absent where too little is left.
std::optional<Swath> fitted(const Ground& ground, const Swath& piece) {
  const Swath back{piece.id, piece.strip, piece.to, piece.from};
  const auto extent_along = [&ground](const Swath& way) {
    const AxisExtent fit = longest_fit(ground, way);
    return without_dead_ends(ground, way, fit);
  };
  const AxisExtent forth_fit = extent_along(piece);
  const AxisExtent back_fit = extent_along(back);
  const bool forth = length_m(forth_fit) >= length_m(back_fit) - 1e-6;
  const Swath& way = forth ? piece : back;
  const AxisExtent fit = forth ? forth_fit : back_fit;
  if (length_m(fit) < kLeastLength * ground.machine.working_width_m) return std::nullopt;
  const Point axis = (1 / distance_m(way.from, way.to)) * (way.to - way.from);
  return Swath{"", 0, way.from + fit.low_m * axis, way.from + fit.high_m * axis};
}

/// Ends where a swath of the same line begins, not a rounding beyond: the machine would have to back up by
/// it.
void meet(Swath& piece, const std::vector<Swath>& swaths) {
  constexpr double kRounding_m = 1e-4;
  const Point axis = (1 / distance_m(piece.from, piece.to)) * (piece.to - piece.from);
  for (Point* end : {&piece.from, &piece.to})
    for (const Swath& swath : swaths)
      for (const Point other : {swath.from, swath.to})
        if (distance_m(*end, other) < kRounding_m) *end = *end + dot(axis, other - *end) * axis;
}

/// Does what the machine fits on still find ground to work? What a piece was laid for may lie beyond its
/// ends.
bool finds_any(const Polygon& part, const Swath& piece, double width_m) {
  constexpr double kAny = 0.02;  // of its strip
  const Polygons found = intersect({part}, {Polygon{strip(piece.from, piece.to, width_m), {}}});
  return area_m2(found) >= kAny * width_m * distance_m(piece.from, piece.to);
}

/// One round of pieces into the unworked ground.
std::vector<Swath> pieces_into(const Ground& ground, const Polygons& left) {
  const double least_m2 = least_pocket_m2(ground.machine);
  Polygons large = left;
  std::erase_if(large, [least_m2](const Polygon& part) { return area_m2(part) < least_m2; });
  std::vector<Swath> pieces;
  for (const Polygon& part : outset_round(inset_round(large, kSliver_m), kSliver_m)) {
    if (area_m2(part) < least_m2) continue;
    for (const Swath& piece : pieces_over(ground, part))
      if (auto fit = fitted(ground, piece); fit && finds_any(part, *fit, ground.machine.working_width_m))
        pieces.push_back(*fit);
  }
  return pieces;
}

}  // namespace

Polygons unworked(const Ground& ground, const Layout& layout, const std::vector<Swath>& pockets) {
  const double flat_rad = -layout.along.radians();  // with the swaths from west to east
  Polygons swept;
  const auto take = [&](const Path& path) {
    for (Ring& piece : swept_by_tool(ground.footprint, path)) swept.push_back({std::move(piece), {}});
  };
  for (const HeadlandPass& pass : layout.headland_passes) {
    if (pass.parts.empty()) take(pass.path);
    for (const HeadlandPart& part : pass.parts) take(part.path);
  }
  for (const Swath& swath : layout.swaths) take(swath_path(ground.machine, swath.from, swath.to));
  for (const Swath& swath : pockets) take(swath_path(ground.machine, swath.from, swath.to));
  return turned(subtract(turned(ground.workable, flat_rad), turned(std::move(swept), flat_rad)), -flat_rad);
}

std::vector<Swath> lay_pockets(const Ground& ground, const Layout& layout) {
  std::vector<Swath> pockets;
  for (int round = 0; round < kRounds; ++round) {
    const Polygons left = unworked(ground, layout, pockets);
    std::vector<Swath> more = pieces_into(ground, left);
    if (more.empty()) break;
    for (Swath& piece : more) meet(piece, layout.swaths);
    pockets.insert(pockets.end(), more.begin(), more.end());
  }
  for (std::size_t k = 0; k < pockets.size(); ++k) pockets[k].id = "P" + std::to_string(k + 1);
  return pockets;
}

}  // namespace selion
