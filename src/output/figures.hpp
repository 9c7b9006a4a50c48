// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "selion/plan/plan.hpp"

namespace selion {

// Figures of a plan that report and map share.

enum class Status { planned, partial, refused };

/// "planned", "partial", "refused".
std::string_view name_of(Status status);

/// Planned where at least 90 % is covered.
Status status_of(const BlockReport& block);
/// Of the whole field: the same share of all its blocks, refused ones included.
Status status_of(const Plan& plan);

/// `part` of `whole` in per cent; 0 of nothing.
double percent(double part, double whole);

/// The blocks added up. What cannot be added (number, reason, bearing, depths) is as in a new BlockReport.
BlockReport total(const std::vector<BlockReport>& blocks);

double driven_m(const BlockReport& block);
double driven_s(const BlockReport& block);
/// What is not covered, all of a refused block included.
double uncovered_m2(const std::vector<BlockReport>& blocks);

/// Shortest and longest of the swaths that are driven, pockets left aside.
struct SwathLengths {
  const SwathRecord* shortest;
  const SwathRecord* longest;
};

/// Of one block, or of all. Absent where no swath is driven.
std::optional<SwathLengths> swath_lengths(const PlanFile& file, std::optional<int> block);

/// Area of the headland bands: their share of the field in an equal-area projection, times the field's area.
double headland_m2(const PlanFile& file);

}  // namespace selion
