// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/core/error.hpp"
#include "selion/core/progress.hpp"
#include "selion/field/block.hpp"
#include "selion/field/field.hpp"
#include "selion/plan/job.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

/// Area worked more than once, by cause; an area worked three times counts twice.
struct WorkedTwice {
  double last_strip_m2 = 0;  ///< the last swath, shifted back over its neighbour
  double wedges_m2 = 0;      ///< swaths run on over a slanted headland
  double corners_m2 = 0;     ///< headland passes over themselves and each other
  double pockets_m2 = 0;     ///< pieces laid into what was left

  [[nodiscard]] double total_m2() const { return last_strip_m2 + wedges_m2 + corners_m2 + pockets_m2; }
  friend bool operator==(const WorkedTwice&, const WorkedTwice&) = default;
};

struct Uncovered {
  LonLatArea area;
  LonLat at;  ///< a place inside it
  double area_m2 = 0;

  friend bool operator==(const Uncovered&, const Uncovered&) = default;
};

/// Of a block or field that counts as planned so much is covered; with less it is partly planned.
constexpr double kPlannedShare = 0.9;

/// How one block came out.
struct BlockReport {
  int number = 1;
  double area_m2 = 0;
  std::string refused;  ///< why it is not planned; empty where it is
  double covered_m2 = 0;
  WorkedTwice twice;
  std::vector<Uncovered> uncovered;  ///< largest first
  double bearing_deg = 0;            ///< of the swaths, A to B
  int swaths = 0;                    ///< strips across the field
  int pieces = 0;                    ///< swath pieces, pocket pieces included
  int headland_passes = 0;
  double headland_depth_m = 0;
  double turn_depth_m = 0;  ///< what the machine's U-turn needs beyond the end of a swath
  double work_m = 0, turn_m = 0, transfer_m = 0, reverse_m = 0;
  double work_s = 0, turn_s = 0, transfer_s = 0;
  int turns = 0;
  int transfers = 0;
  int pivots = 0;
  double scrub_m = 0;  ///< what the tyres of each side slide in them

  friend bool operator==(const BlockReport&, const BlockReport&) = default;
};

/// What the independent check (verify) said of the plan file.
struct Verification {
  std::vector<std::string> faults;  ///< none: it passed

  friend bool operator==(const Verification&, const Verification&) = default;
};

struct Plan {
  PlanFile file;
  std::vector<BlockReport> blocks;
  std::vector<std::string> notes;            ///< repairs, choices made, parts left out
  std::vector<std::string> assumptions;      ///< machine, flat ground, boundary accuracy, datum
  std::optional<Verification> verification;  ///< set by whoever had it verified

  friend bool operator==(const Plan&, const Plan&) = default;
};

/// The whole line for one field: frame, blocks, direction, layout, route, trajectory, figures.
/// Infeasible only when no block can be planned. @throws InputError from cleaning and from the job.
Result<Plan> plan(const Field& field, const Job& job, Repair repair, const Progress& progress);

}  // namespace selion
