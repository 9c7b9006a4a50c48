// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/plan/plan.hpp"

#include <algorithm>

#include "coverage.hpp"
#include "describe.hpp"
#include "layout_options.hpp"
#include "records.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/field/frame.hpp"
#include "selion/layout/layout.hpp"
#include "selion/layout/zones.hpp"
#include "selion/motion/timed_turn.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/route/route.hpp"

namespace selion {
namespace {

/// The blocks cut where the machine cannot pass, numbered anew.
Blocks for_machine(Blocks cleaned, const Machine& machine) {
  std::vector<Block> zones;
  for (const Block& block : cleaned.blocks) {
    const std::vector<Block> parts = zones_of(block, machine);
    if (parts.size() > 1)
      cleaned.notes.push_back(
          "Block " + std::to_string(block.number) + " falls into " + std::to_string(parts.size()) +
          " blocks: the necks between them are too narrow for the machine at its full width.");
    zones.insert(zones.end(), parts.begin(), parts.end());
  }
  for (std::size_t i = 0; i < zones.size(); ++i) zones[i].number = static_cast<int>(i) + 1;
  cleaned.blocks = std::move(zones);
  return cleaned;
}

LocalFrame frame_of(const Field& field, const Job& job) {
  return job.frame.crs == "auto" ? LocalFrame::centred(centre(field))
                                 : LocalFrame::of_crs(job.frame.crs, centre(field));
}

Result<Layout> lay_out(const Block& block, const LocalFrame& frame, const Job& job, Interior interior) {
  auto options = layout_options(block, frame, job);
  if (!options) return options.error();
  options->interior = interior;
  const auto kinds = layouts();
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const LayoutKind& k) { return k.name == job.layout.kind; });
  if (kind == kinds.end()) throw InputError{"layout.kind = \"" + job.layout.kind + "\" is not known"};
  return kind->lay_out(block, job.machine, *options);
}

RouteOptions route_options(const Block& block, const Job& job) {
  RouteOptions options;
  options.headland = job.headland.order;
  options.gate = gate_of(block, job.route.start);
  return options;
}

struct Attempt {
  Interior interior = Interior::swaths;
  double beyond_m2 = 0;  ///< not driven where it can hardly cover more
};

/// Not all that lines cover is reached: to promise a hair more is not worth a try, unless the block would be
/// well covered.
bool promises_more(double lines_m2, double beyond_m2, const Block& block) {
  constexpr double kGain = 0.01;
  const double area = area_m2(block.area);
  const double enough_m2 = kPlannedShare * area;
  return lines_m2 > beyond_m2 + kGain * area || (lines_m2 >= enough_m2 && beyond_m2 < enough_m2);
}

Result<PlannedBlock> plan_as_told(const Block& block, const LocalFrame& frame, const Job& job,
                                  const Progress& progress, const Attempt& attempt = {}) {
  progress("laying out", 0);
  auto layout = lay_out(block, frame, job, attempt.interior);
  if (!layout) return layout.error();
  if (attempt.beyond_m2 > 0 &&
      !promises_more(coverage_of_all(block, *layout, job.machine).covered_m2, attempt.beyond_m2, block))
    return Infeasible{"it would cover hardly more"};
  auto driven = route(block, *layout, job.machine, route_options(block, job), progress);
  if (!driven) return driven.error();
  Coverage coverage = coverage_of(block, *layout, *driven, job.machine);
  return PlannedBlock{block, std::move(*layout), std::move(*driven), std::move(coverage)};
}

bool covers(const PlannedBlock& planned, double share) {
  return planned.coverage.covered_m2 >= share * area_m2(planned.block.area);
}

bool covers_more(const Result<PlannedBlock>& a, const Result<PlannedBlock>& b) {
  return a && (!b || a->coverage.covered_m2 > b->coverage.covered_m2);
}

std::string fewer_note(int passes, int needed) {
  return "It is planned with " + std::to_string(passes) +
         (passes == 1 ? " headland pass" : " headland passes") + " instead of the " + std::to_string(needed) +
         " that turns need: inside those lies no swath.";
}

std::string passes_alone_note(int passes) {
  return "It is worked along its borders, by " + std::to_string(passes) +
         (passes == 1 ? " headland pass" : " headland passes") +
         " alone: it is too narrow, or bends too much, for swaths to cover more.";
}

Infeasible hardly_covered(const Infeasible& why, const PlannedBlock& best) {
  const double percent = 100 * best.coverage.covered_m2 / area_m2(best.block.area);
  return Infeasible{why.reason + "; with fewer passes only " + fixed(percent, 1) +
                    " % of it would be covered"};
}

double covered_m2(const Result<PlannedBlock>& planned) { return planned ? planned->coverage.covered_m2 : 0; }
bool is_well_covered(const Result<PlannedBlock>& planned) {
  return planned && covers(*planned, kPlannedShare);
}

/// With the most headland passes below what turns need that leave it well covered, else with those that cover
/// most.
Result<PlannedBlock> with_fewer_passes(const Block& block, const LocalFrame& frame, Job job, int needed,
                                       const Progress& progress) {
  Result<PlannedBlock> best = Infeasible{};
  for (int passes = needed - 1; passes >= 0 && !is_well_covered(best); --passes) {
    job.headland.passes = passes;
    auto other = plan_as_told(block, frame, job, progress, {Interior::swaths, covered_m2(best)});
    if (other) other->route.notes.push_back(fewer_note(passes, needed));
    if (!best || covers_more(other, best)) best = std::move(other);
  }
  return best;
}

Result<PlannedBlock> with_passes_alone(const Block& block, const LocalFrame& frame, const Job& job,
                                       double beyond_m2, const Progress& progress) {
  auto along = plan_as_told(block, frame, job, progress, {Interior::nothing, beyond_m2});
  if (along) along->route.notes.push_back(passes_alone_note(along->layout.passes));
  return along;
}

/// Of a block too narrow for as many headland passes as turns need, unless it is hardly worth a plan.
Result<PlannedBlock> plan_inside_fewer(const Infeasible& refused, const Block& block, const LocalFrame& frame,
                                       const Job& job, const Progress& progress) {
  constexpr double kWorthIt = 0.5;
  const auto options = layout_options(block, frame, job);
  if (!options) return options.error();
  const int needed = passes_for_turns(block, job.machine, *options);
  auto best = with_fewer_passes(block, frame, job, needed, progress);
  if (!is_well_covered(best)) {
    auto along = with_passes_alone(block, frame, job, covered_m2(best), progress);
    if (covers_more(along, best)) best = std::move(along);
  }
  if (best && !covers(*best, kWorthIt)) return hardly_covered(refused, *best);
  return best;
}

/// With as many headland passes as the job says, or turns need.
Result<PlannedBlock> plan_with_headland(const Block& block, const LocalFrame& frame, const Job& job,
                                        const Progress& progress) {
  auto planned = plan_as_told(block, frame, job, progress);
  if (planned || job.headland.passes) return planned;
  return plan_inside_fewer(planned.error(), block, frame, job, progress);
}

/// Corners are filled where that covers more: what it takes to fill them may be in the way of other work.
Result<PlannedBlock> plan_block(const Block& block, const LocalFrame& frame, const Job& job,
                                const Progress& progress) {
  auto planned = plan_with_headland(block, frame, job, progress);
  if (job.headland.corners == HeadlandCorners::round) return planned;
  Job rounded = job;
  rounded.headland.corners = HeadlandCorners::round;
  auto other = plan_with_headland(block, frame, rounded, progress);
  if (!covers_more(other, planned)) return planned;
  other->route.notes.emplace_back("Its corners are rounded: filling them would leave more ground unworked.");
  return other;
}

/// What turns are laid out for. They are driven as fast as the machine may.
Job for_fast_turns(Job job) {
  job.machine.turn_speed_mps =
      swath_turn_speed_mps(job.machine, job.machine.working_width_m - job.layout.overlap_m);
  return job;
}

void add_block(Plan& plan, const PlannedBlock& planned, const LocalFrame& frame, const Job& job) {
  const Drive drive = drive_of(planned.route, job.machine);
  add_records(plan.file, planned, drive, frame, job.machine);
  plan.blocks.push_back(report_of(planned, drive, frame, job));
  for (const std::string& note : notes_of(planned)) plan.notes.push_back(note);
  for (const std::string& warning : planned.route.warnings)
    plan.file.warnings.push_back("Block " + std::to_string(planned.block.number) + ": " + warning);
}

}  // namespace

Result<Plan> plan(const Field& field, const Job& job, Repair repair, const Progress& progress) {
  validate(job);
  const LocalFrame frame = frame_of(field, job);
  const Blocks cleaned =
      for_machine(blocks_of(field, frame, {job.field.obstacle_clearance_m, job.field.water_margin_m, repair}),
                  job.machine);
  check_start(cleaned, job.route.start);
  Plan plan = described(field, job, frame, cleaned);
  const Job for_turns = for_fast_turns(job);
  std::string reasons;
  for (const Block& block : cleaned.blocks) {
    const auto planned = plan_block(block, frame, for_turns, progress);
    if (planned) {
      add_block(plan, *planned, frame, job);
      continue;
    }
    plan.blocks.push_back(refused(block, planned.error()));
    reasons += (reasons.empty() ? "" : "; ") + block_name(block, cleaned) + planned.error().reason;
  }
  if (plan.file.trajectories.empty()) return Infeasible{reasons};
  summarise(plan);
  progress("planned", 1);
  return plan;
}

}  // namespace selion
