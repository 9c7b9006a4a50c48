// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/plan/plan.hpp"

#include <utility>

#include "describe.hpp"
#include "plan_block.hpp"
#include "records.hpp"
#include "selion/field/frame.hpp"
#include "selion/layout/zones.hpp"
#include "selion/motion/timed_turn.hpp"
#include "selion/plan/job_file.hpp"

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
