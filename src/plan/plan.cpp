// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/plan/plan.hpp"

#include <algorithm>
#include <charconv>

#include "coverage.hpp"
#include "describe.hpp"
#include "records.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "selion/field/frame.hpp"
#include "selion/geometry/simplify.hpp"
#include "selion/layout/layout.hpp"
#include "selion/layout/zones.hpp"
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

/// A compass heading in the local frame, whose north leans by the convergence.
double local_heading_rad(const LocalFrame& frame, Point at, double bearing_deg) {
  return radians_of_degrees(90 - bearing_deg + frame.convergence_deg(at));
}

/// Sets direction and heading as `layout.direction` says.
std::optional<Infeasible> choose_direction(LayoutOptions& options, const Block& block,
                                           const LocalFrame& frame, const Job& job) {
  const std::string& how = job.layout.direction;
  if (how == "edge") {
    // steps and wiggles smaller than half the working width cost no swath piece: they must not choose
    options.along = best_edge_direction(simplified(block.area, job.machine.working_width_m / 2));
  } else if (how == "p3") {
    const auto found = p3_direction(block.area);
    if (!found) return found.error();
    options.along = found->along;
  } else {
    double bearing = 0;
    std::from_chars(how.data(), how.data() + how.size(), bearing);  // the job was validated
    options.heading_rad = local_heading_rad(frame, centroid(block.area), bearing);
    options.along = DrivingDirection::radians(*options.heading_rad);
  }
  return std::nullopt;
}

/// @throws InputError where the line lies nowhere near the block.
AbLine ab_line_of(const Block& block, const LocalFrame& frame, const std::array<double, 4>& given) {
  constexpr double kFar_m = 10'000;
  const auto& [lon_a, lat_a, lon_b, lat_b] = given;
  const AbLine ab{frame.to_local({lon_a, lat_a}), frame.to_local({lon_b, lat_b})};
  const double far_m =
      std::min(distance_m(ab.a, centroid(block.area)), distance_m(ab.b, centroid(block.area)));
  if (!(far_m < kFar_m))
    throw InputError{
        "layout.ab lies more than 10 km from the field: give A and B as lon,lat,lon,lat; are "
        "longitude and latitude swapped?"};
  return ab;
}

Result<LayoutOptions> layout_options(const Block& block, const LocalFrame& frame, const Job& job) {
  LayoutOptions options;
  options.ab_shift_m = job.layout.ab_shift_m;
  options.overlap_m = job.layout.overlap_m;
  options.edge_margin_m = job.field.edge_margin_m;
  options.passes = job.headland.passes;
  options.corners = job.headland.corners;
  if (job.layout.ab) {
    options.ab = ab_line_of(block, frame, *job.layout.ab);
    return options;
  }
  if (const auto why = choose_direction(options, block, frame, job)) return *why;
  return options;
}

Result<Layout> lay_out(const Block& block, const LocalFrame& frame, const Job& job) {
  const auto options = layout_options(block, frame, job);
  if (!options) return options.error();
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

Result<PlannedBlock> plan_as_told(const Block& block, const LocalFrame& frame, const Job& job,
                                  const Progress& progress) {
  progress("laying out", 0);
  auto layout = lay_out(block, frame, job);
  if (!layout) return layout.error();
  auto driven = route(block, *layout, job.machine, route_options(block, job), progress);
  if (!driven) return driven.error();
  return PlannedBlock{block, std::move(*layout), std::move(*driven)};
}

double covered_m2(const PlannedBlock& planned, const Machine& machine) {
  return coverage_of(planned.block, planned.layout, planned.route, machine).covered_m2;
}

/// Corners are filled where that covers more: what it takes to fill them may be in the way of other work.
Result<PlannedBlock> plan_block(const Block& block, const LocalFrame& frame, const Job& job,
                                const Progress& progress) {
  auto planned = plan_as_told(block, frame, job, progress);
  if (job.headland.corners == HeadlandCorners::round) return planned;
  Job rounded = job;
  rounded.headland.corners = HeadlandCorners::round;
  auto other = plan_as_told(block, frame, rounded, progress);
  if (!other || (planned && covered_m2(*planned, job.machine) >= covered_m2(*other, job.machine)))
    return planned;
  other->route.notes.emplace_back("Its corners are rounded: filling them would leave more ground unworked.");
  return other;
}

void add_block(Plan& plan, const PlannedBlock& planned, const LocalFrame& frame, const Job& job) {
  const Drive drive = drive_of(planned.route, job.machine);
  add_records(plan.file, planned, drive, frame, job.machine);
  plan.blocks.push_back(report_of(planned, drive, frame, job));
  for (const std::string& note : notes_of(planned)) plan.notes.push_back(note);
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
  std::string reasons;
  for (const Block& block : cleaned.blocks) {
    const auto planned = plan_block(block, frame, job, progress);
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
