// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "border.hpp"
#include "driven.hpp"
#include "findings.hpp"
#include "geos.hpp"
#include "plane.hpp"
#include "selion/verify/verify.hpp"
#include "vehicle.hpp"

namespace selion::verifying {

constexpr double kInside_m = 0.01;  // "inside" allows as much (docs/architecture.md)

/// One block: where body and tool may be.
struct Ground {
  int block = 1;
  Shape area;       ///< as the plan file has it
  Shape edge;       ///< its border, but holes and obstacles: the edge margin is kept from it
  Shape obstacles;  ///< of the plan file, with what is kept from them; none: empty
  Shape kept;       ///< these, and holes with what is kept from those
  Shape free;       ///< the area less these
  Prepared room;    ///< as much, and kInside_m around it
  Border border;    ///< of `room`
};

/// A plan taken apart, and what is found in it.
struct Case {
  const PlanFile& plan;
  const Plane& plane;
  const Vehicle& vehicle;
  std::vector<Ground> grounds;
  std::vector<Driven> drives;
  Findings& findings;
  std::optional<Border> thin = std::nullopt;  ///< of obstacles that are too thin to be seen in `room`

  [[nodiscard]] const Ground* ground(int block) const;
};

/// "robot 1, piece 17 (swath 12a)", counted from 1.
std::string piece_name(const Driven& driven, std::size_t piece);

/// False where a border crosses itself so often that to follow it would take long and tell nothing.
bool check_tangles(Case& plan);
/// Of the plan's field: rings that cross, areas. Fills `grounds`.
void check_grounds(Case& plan);
/// False where a trajectory has numbers that no machine drives in its block, so that following it would take
/// long and tell nothing.
bool check_reach(Case& plan);
/// Against the field as its owner has it. @throws InputError where it cannot be read.
void check_given(Case& plan, const GivenField& given);
/// Pieces end to end: place, heading, curvature; what each may be.
void check_joints(Case& plan, const Driven& driven);
/// Curvature of each piece, tool down or up.
void check_bends(Case& plan, const Driven& driven);
/// Finds the samples on the pieces, and says where they do not belong. Fills `moments`.
void check_samples(Case& plan, Driven& driven);
/// Speeds, acceleration, lateral acceleration and steering between the moments.
void check_speeds(Case& plan, const Driven& driven);
/// Standing where pieces wait, pivot or change the gear: that it does, for how long, how fast it pivots and
/// steers there.
void check_stops(Case& plan, const Driven& driven);
/// The time that lowering and raising the tool takes, and where it is lowered.
void check_tool(Case& plan, const Driven& driven);
/// Body and tool in the block and clear of obstacles, everywhere.
void check_inside(Case& plan, const Driven& driven);
/// Swaths keep the edge margin; headland passes may use it at corners (check_rings).
void check_margin(Case& plan, const Driven& driven);
/// Each swath and pass once, where its line lies, in its order.
void check_lines(Case& plan);
/// Blocks of all records.
void check_records(Case& plan);
/// Swaths and headland passes are driven as what they are; numbers of robots.
void check_kinds(Case& plan);
/// Gates: where they lie, and the one that is driven through.
void check_gates(Case& plan);
/// AB lines and cells, and how swaths lie to them and to each other.
void check_ab(Case& plan);
/// Number of the strip that a swath is a piece of: "12a" is of 12, "L1" of 0. Of a pocket none.
std::optional<int> strip_of(const std::string& id);
/// The headland before or after the swaths, as the job has it.
void check_order(Case& plan, const Driven& driven);
/// Headlands: their depth, their share of the block, no swaths among their passes.
void check_headlands(Case& plan);
/// Headland passes: their rings, and how near to the border they lie.
void check_rings(Case& plan);
/// The ground covered. Fills the verdict's areas and places.
void check_coverage(Case& plan, Verdict& verdict);
/// Ground under two or more steps of the tool, as places.
std::vector<VerifiedPlace> places_worked_twice(const Case& plan);
/// Every figure of the summary.
void check_summary(Case& plan, const Verdict& verdict);
/// Waits for other robots: that these come by, and before the wait ends.
void check_waits(Case& plan);
/// Robots against each other, at any time.
void check_robots(Case& plan);

}  // namespace selion::verifying
