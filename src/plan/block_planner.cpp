// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_planner.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "coverage.hpp"
#include "describe.hpp"
#include "layout_options.hpp"
#include "selion/core/format.hpp"
#include "selion/plan/plan.hpp"

namespace selion {
namespace {

bool covers(const PlannedBlock& planned, double share) {
  return planned.coverage.covered_m2 >= share * area_m2(planned.block.area);
}

bool is_well_covered(const Result<PlannedBlock>& planned) {
  return planned && covers(*planned, kPlannedShare);
}

double covered_m2(const Result<PlannedBlock>& planned) { return planned ? planned->coverage.covered_m2 : 0; }

struct Driven {
  double all_m = 0;
  double work_m = 0;
};

Driven driven_on(const Route& route) {
  Driven driven;
  for (const RoutePiece& piece : route.pieces) {
    const double length = length_m(piece.path);
    const bool works = piece.kind == PieceKind::swath || piece.kind == PieceKind::headland_pass;
    driven.all_m += length;
    if (works) driven.work_m += length;
  }
  return driven;
}

/// Much of the drive is not work: between short swaths in a bend.
bool wanders(const PlannedBlock& planned) {
  constexpr double kMostlyWork = 0.74;
  const Driven driven = driven_on(planned.route);
  return driven.work_m < kMostlyWork * driven.all_m;
}

bool drives_less(const PlannedBlock& a, const PlannedBlock& b) {
  constexpr double kLess = 0.95;
  return driven_on(a.route).all_m < kLess * driven_on(b.route).all_m;
}

constexpr double kNoLess = 0.01;  // of a block's area

bool covers_no_less(const PlannedBlock& a, const PlannedBlock& b) {
  return a.coverage.covered_m2 >= b.coverage.covered_m2 - kNoLess * area_m2(b.block.area);
}

/// Not all that lines cover is reached: to promise a hair more is not worth a try, unless the block would be
/// well covered.
bool promises_more(double lines_m2, double beyond_m2, const Block& block) {
  constexpr double kGain = 0.01;
  const double area = area_m2(block.area);
  const double enough_m2 = kPlannedShare * area;
  return lines_m2 > beyond_m2 + kGain * area || (lines_m2 >= enough_m2 && beyond_m2 < enough_m2);
}

std::string fewer_note(int passes, int needed, const std::string& why) {
  return "It is planned with " + std::to_string(passes) +
         (passes == 1 ? " headland pass" : " headland passes") + " instead of the " + std::to_string(needed) +
         " that turns need: " + why;
}

std::string passes_alone_note(int passes) {
  return "It is worked along its borders, by " + std::to_string(passes) +
         (passes == 1 ? " headland pass" : " headland passes") +
         " alone: it is too narrow, or bends too much, for swaths to do better.";
}

Infeasible hardly_covered(const Infeasible& why, const PlannedBlock& best) {
  const double percent = 100 * best.coverage.covered_m2 / area_m2(best.block.area);
  return Infeasible{why.reason + "; with fewer passes only " + fixed(percent, 1) +
                    " % of it would be covered"};
}

}  // namespace

bool covers_more(const Result<PlannedBlock>& a, const Result<PlannedBlock>& b) {
  return a && (!b || a->coverage.covered_m2 > b->coverage.covered_m2);
}

BlockPlanner::BlockPlanner(const Block& block, const LocalFrame& frame, const Progress& progress)
    : block_{block}, frame_{frame}, progress_{progress}, known_{nothing_known()} {}

Result<PlannedBlock> BlockPlanner::planned(const Job& job, double border_room_m) {
  border_room_m_ = border_room_m;
  auto planned = with_headland(job);
  if (job.headland.corners == HeadlandCorners::round) return planned;
  Job rounded = job;
  rounded.headland.corners = HeadlandCorners::round;
  auto other = with_headland(rounded);
  if (!covers_more(other, planned)) return planned;
  other->route.notes.emplace_back("Its corners are rounded: filling them would leave more ground unworked.");
  return other;
}

Result<Layout> BlockPlanner::laid_out(const Job& job, Interior interior) const {
  auto options = layout_options(block_, frame_, job);
  if (!options) return options.error();
  options->interior = interior;
  options->border_room_m = border_room_m_;
  const auto kinds = layouts();
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const LayoutKind& k) { return k.name == job.layout.kind; });
  if (kind == kinds.end()) throw InputError{"layout.kind = \"" + job.layout.kind + "\" is not known"};
  return kind->lay_out(block_, job.machine, *options);
}

RouteOptions BlockPlanner::route_options(const Job& job) const {
  RouteOptions options;
  options.headland = job.headland.order;
  options.gate = gate_of(block_, job.route.start);
  options.known = known_;
  return options;
}

Result<PlannedBlock> BlockPlanner::as_told(const Job& job, const Attempt& attempt) const {
  progress_("laying out", 0);
  auto layout = laid_out(job, attempt.interior);
  if (!layout) return layout.error();
  if (attempt.beyond_m2 > 0 &&
      !promises_more(coverage_of_all(block_, *layout, job.machine).covered_m2, attempt.beyond_m2, block_))
    return Infeasible{"it would cover hardly more"};
  auto driven = route(block_, *layout, job.machine, route_options(job), progress_);
  if (!driven) return driven.error();
  Coverage coverage = coverage_of(block_, *layout, *driven, job.machine);
  return PlannedBlock{block_, std::move(*layout), std::move(*driven), std::move(coverage)};
}

/// With as many headland passes as the job says, or turns need.
Result<PlannedBlock> BlockPlanner::with_headland(const Job& job) const {
  auto planned = as_told(job, {});
  if (job.headland.passes) return planned;
  if (!planned) return inside_fewer(planned.error(), job);
  if (!is_well_covered(planned)) {
    const int needed = planned->layout.passes;
    planned = with_fewer_passes(job, needed, std::move(planned));
  }
  return is_narrow(job) ? or_along_borders(std::move(planned), job) : std::move(planned);
}

/// A few passes wide, on average.
bool BlockPlanner::is_narrow(const Job& job) const {
  constexpr double kMostPasses = 8;
  const Polygon& area = block_.area;
  return 2 * area_m2(area) < kMostPasses * job.machine.working_width_m * perimeter_m(area);
}

/// Round holes, and narrow: going round and round takes no turns.
bool BlockPlanner::is_closed_band(const Job& job) const {
  return !block_.area.holes.empty() && is_narrow(job);
}

/// Of a block too narrow for as many headland passes as turns need, unless it is hardly worth a plan.
Result<PlannedBlock> BlockPlanner::inside_fewer(const Infeasible& refused, const Job& job) const {
  constexpr double kWorthIt = 0.5;
  const auto options = layout_options(block_, frame_, job);
  if (!options) return options.error();
  auto best = or_along_borders(
      with_fewer_passes(job, passes_for_turns(block_, job.machine, *options), Infeasible{}), job);
  if (best && !covers(*best, kWorthIt)) return hardly_covered(refused, *best);
  return best;
}

/// With the most headland passes below what turns need that leave it well covered, else with those that
/// cover most.
Result<PlannedBlock> BlockPlanner::with_fewer_passes(Job job, int needed, Result<PlannedBlock> best) const {
  const std::string why = best ? "with those more ground would be left." : "inside those lies no swath.";
  for (int passes = needed - 1; passes >= 0 && !is_well_covered(best); --passes) {
    job.headland.passes = passes;
    auto other = as_told(job, {Interior::swaths, covered_m2(best)});
    if (other) other->route.notes.push_back(fewer_note(passes, needed, why));
    if (!best || covers_more(other, best)) best = std::move(other);
  }
  return best;
}

/// Where swaths cover it badly, or much of the drive leads from one to the next, or it is a closed band.
Result<PlannedBlock> BlockPlanner::or_along_borders(Result<PlannedBlock> best, const Job& job) const {
  if (!is_well_covered(best)) {
    auto along = with_passes_alone(job, covered_m2(best));
    return covers_more(along, best) ? std::move(along) : std::move(best);
  }
  if (!wanders(*best) && !is_closed_band(job)) return best;
  auto along = with_passes_alone(job, covered_m2(best) - 2 * kNoLess * area_m2(block_.area));
  return is_well_covered(along) && covers_no_less(*along, *best) && drives_less(*along, *best)
             ? std::move(along)
             : std::move(best);
}

Result<PlannedBlock> BlockPlanner::with_passes_alone(const Job& job, double beyond_m2) const {
  auto along = as_told(job, {Interior::nothing, beyond_m2});
  if (along) along->route.notes.push_back(passes_alone_note(along->layout.passes));
  return along;
}

}  // namespace selion
