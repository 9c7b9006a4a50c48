// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_block.hpp"

#include <string>
#include <utility>

#include "block_planner.hpp"
#include "selion/core/format.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

/// Much of the ground that the outermost passes are to work is left.
bool misses_the_border(const PlannedBlock& planned, const Job& job) {
  constexpr double kMuch = 0.1;
  constexpr double kNear = 0.05;  // of the working width; a border may have thousands of corners
  const double width_m = job.machine.working_width_m;
  const double margin_m = job.field.edge_margin_m;
  const Polygons all{simplified(planned.block.area, kNear * width_m)};
  const Polygons band = subtract(inset(all, margin_m), inset(all, margin_m + width_m));
  return area_m2(intersect(planned.coverage.uncovered, band)) > kMuch * area_m2(band);
}

std::string room_note(double room_m) {
  return "Its outermost passes keep " + fixed(100 * room_m, 0) +
         " cm further off the border than the edge margin: closer, the machine cannot drive them.";
}

/// Along a border that bends gently all the way the body's front swings out over it: by its length squared
/// over twice the radius. Where the passes there cannot be driven so close, or not be come onto, a few
/// centimetres further off they can.
Result<PlannedBlock> or_with_room(BlockPlanner& planner, Result<PlannedBlock> best, const Job& job) {
  const double front_m = job.machine.front_m;
  for (const double radius_m : {30.0, 12.0}) {
    if (!best || !misses_the_border(*best, job)) break;
    auto other = planner.planned(job, front_m * front_m / (2 * radius_m));
    if (!covers_more(other, best)) continue;
    other->route.notes.emplace_back(room_note(front_m * front_m / (2 * radius_m)));
    best = std::move(other);
  }
  return best;
}

}  // namespace

Result<PlannedBlock> plan_block(const Block& block, const LocalFrame& frame, const Job& job,
                                const Progress& progress) {
  BlockPlanner planner{block, frame, progress};
  return or_with_room(planner, planner.planned(job), job);
}

}  // namespace selion
