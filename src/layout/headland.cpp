// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <utility>

#include "parts.hpp"
#include "swept_ground.hpp"

namespace selion {
namespace {

std::vector<Ring> rings_of(const Polygons& areas) {
  std::vector<Ring> rings;
  for (const Polygon& area : areas) {
    rings.push_back(area.shell);
    rings.insert(rings.end(), area.holes.begin(), area.holes.end());
  }
  return rings;
}

bool is_convex(const Polygon& area) {
  const Ring& ring = area.shell;
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point before = ring[(i + count - 1) % count];
    if (cross(ring[i] - before, ring[(i + 1) % count] - ring[i]) < 0) return false;
  }
  return area.holes.empty();
}

/// Less what is too narrow to drive in and out of again side by side.
Polygons without_slits(const Ground& ground, const Polygons& areas) {
  constexpr double kOfRadius = 0.6;
  constexpr double kSharpest = 20;
  if (areas.size() == 1 && is_convex(areas.front())) return areas;
  const double narrow_m = kOfRadius / max_curvature_per_m(ground.machine);
  return intersect(outset(inset(areas, narrow_m), narrow_m, kSharpest), areas);
}

constexpr double kLeastInSlit = 1.5;  // of the working width: a shorter run is not worth a pass

/// Along one side of the slit, and along others where that works more. A machine that drives forwards only
/// gets out of no dead end: it drives round in the slit, or not at all.
void add_runs_in(const Ground& ground, const Polygon& slit, double room_m, std::vector<HeadlandRun>& runs) {
  constexpr double kLeastNew = 0.15;  // of the working width, not worked by the runs before
  const double width_m = ground.machine.working_width_m;
  std::vector<HeadlandRun> sides;
  for (const Ring& side : rings_of({slit}))
    for (HeadlandRun& run : drivable_along(ground, side, room_m))
      if (run.closed || ground.machine.may_reverse) sides.push_back(std::move(run));
  std::stable_sort(sides.begin(), sides.end(), [](const HeadlandRun& a, const HeadlandRun& b) {
    return length_m(a.path) > length_m(b.path);
  });
  Polygons worked;
  for (HeadlandRun& side : sides) {
    const double side_m = length_m(side.path);
    Polygons swept = swept_by(ground.footprint, side.path);
    if (side_m < kLeastInSlit * width_m || area_m2(subtract(swept, worked)) < kLeastNew * width_m * side_m)
      continue;
    worked.insert(worked.end(), std::make_move_iterator(swept.begin()), std::make_move_iterator(swept.end()));
    runs.push_back(std::move(side));
  }
}

/// In long slits, which no ring goes round in side by side.
std::vector<HeadlandRun> runs_in_slits(const Ground& ground, const Polygons& all, const Polygons& wide,
                                       double room_m) {
  std::vector<HeadlandRun> runs;
  for (const Polygon& slit : subtract(all, outset_round(wide, kFollow_m))) {
    const Box box = bounds(slit.shell);
    if (distance_m(box.low, box.high) >= 2 * kLeastInSlit * ground.machine.working_width_m)
      add_runs_in(ground, slit, room_m, runs);
  }
  return runs;
}

HeadlandPass pass_of(const Ground& ground, std::size_t number, int ring, HeadlandRun run) {
  const bool either_way = fits(ground.space, ground.footprint, turned_round(run.path));
  return {"H" + std::to_string(number), ring, std::move(run.path), run.closed, {}, either_way};
}

}  // namespace

namespace {

double plain_inset_m(const Ground& ground, int ring) {
  return ground.half_m + kFollow_m + (ring - 1) * (ground.machine.working_width_m - 2 * kFollow_m);
}

}  // namespace

double ring_inset_m(const Ground& ground, int ring) {
  return plain_inset_m(ground, ring) + (ring == 1 ? ground.border_room_m : 0);
}

double mainland_inset_m(const Ground& ground, int passes) {
  if (passes == 0) return 0;
  return plain_inset_m(ground, passes) + ground.machine.working_width_m / 2 - kFollow_m;
}

/// Between the lane of a ring, as wide as the wider of tool and body, and the field's border.
double swing_out_room_m(const Ground& ground, int ring) {
  return ground.edge_margin_m + ring_inset_m(ground, ring) - ground.half_m;
}

namespace {

std::vector<HeadlandRun> runs_at(const Ground& ground, double inset_m, double room_m) {
  const Polygons all = inset(ground.workable, inset_m);
  const Polygons wide = without_slits(ground, all);
  std::vector<HeadlandRun> runs;
  for (const Ring& line : rings_of(wide)) {
    std::vector<HeadlandRun> along = drivable_along(ground, line, room_m);
    runs.insert(runs.end(), std::make_move_iterator(along.begin()), std::make_move_iterator(along.end()));
  }
  std::vector<HeadlandRun> narrow = runs_in_slits(ground, all, wide, room_m);
  runs.insert(runs.end(), std::make_move_iterator(narrow.begin()), std::make_move_iterator(narrow.end()));
  return runs;
}

void add_ring(const Ground& ground, int ring, std::vector<HeadlandRun> runs,
              std::vector<HeadlandPass>& laid) {
  for (HeadlandRun& run : runs) laid.push_back(pass_of(ground, laid.size() + 1, ring, std::move(run)));
}

/// Worked by runs, once and altogether.
struct Swept {
  double once_m2 = 0;
  double all_m2 = 0;
};

Swept swept_on(const Ground& ground, const std::vector<HeadlandRun>& runs) {
  Polygons swept;
  for (const HeadlandRun& run : runs) {
    Polygons its = unite(swept_by(ground.footprint, run.path));
    swept.insert(swept.end(), std::make_move_iterator(its.begin()), std::make_move_iterator(its.end()));
  }
  return {area_m2(unite(swept)), area_m2(swept)};
}

/// The deepest place of the workable ground below a depth at which none is left, at least `within_m`.
double middle_m(const Ground& ground, double within_m, double beyond_m) {
  constexpr double kStep_m = 0.1;
  while (beyond_m - within_m > kStep_m) {
    const double between_m = (within_m + beyond_m) / 2;
    (inset(ground.workable, between_m).empty() ? beyond_m : within_m) = between_m;
  }
  return within_m;
}

}  // namespace

std::vector<HeadlandPass> lay_headland(const Ground& ground, int passes) {
  std::vector<HeadlandPass> laid;
  for (int ring = 1; ring <= passes; ++ring)
    add_ring(ground, ring, runs_at(ground, ring_inset_m(ground, ring), swing_out_room_m(ground, ring)), laid);
  return laid;
}

/// Hardly anything is as deep as the middle of the widest place: the line lies as much further out, within
/// what the tool reaches across, as works most, unless it is then driven there and back.
void lay_between(const Ground& ground, int passes, std::vector<HeadlandPass>& laid) {
  constexpr double kLeastBetween = 0.15;  // of the working width
  constexpr double kMore = 1.2;
  constexpr double kMoreSquares = 4;  // of the working width
  constexpr double kHardlyTwice = 1.15;
  const double width_m = ground.machine.working_width_m;
  if (passes == 0) return;
  const double within_m = ring_inset_m(ground, passes);
  const double beyond_m = ring_inset_m(ground, passes + 1);
  const double least_m = within_m + (1 + kLeastBetween) * width_m / 2;
  const double deepest_m = middle_m(ground, within_m, beyond_m);
  std::vector<HeadlandRun> best;
  double best_m2 = 0;
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    const double inset_m = deepest_m - share * (beyond_m - deepest_m);
    if (inset_m < least_m) break;
    auto runs = runs_at(ground, inset_m, swing_out_room_m(ground, passes + 1));
    const Swept swept = swept_on(ground, runs);
    if (share > 0 &&
        (swept.once_m2 < kMore * best_m2 || swept.once_m2 < best_m2 + kMoreSquares * width_m * width_m ||
         swept.all_m2 > kHardlyTwice * swept.once_m2))
      continue;
    best_m2 = swept.once_m2;
    best = std::move(runs);
  }
  add_ring(ground, passes + 1, std::move(best), laid);
}

}  // namespace selion
