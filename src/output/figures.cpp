// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures.hpp"

#include <algorithm>
#include <cmath>

#include "selion/core/units.hpp"

namespace selion {
namespace {

/// Proportional to the ring's area on the Earth: x is the longitude and y the sine of the latitude (Lambert's
/// cylindrical projection).
double relative_area(const LonLatLine& ring) {
  const auto projected = [&](std::size_t i) {
    const auto height = [](LonLat at) { return std::sin(radians_of_degrees(at.lat_deg)); };
    return Point{ring[i].lon_deg - ring[0].lon_deg, height(ring[i]) - height(ring[0])};
  };
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) doubled += cross(projected(i), projected(i + 1));
  return std::abs(doubled) / 2;
}

double relative_area(const std::vector<LonLatArea>& parts) {
  double area = 0;
  for (const LonLatArea& part : parts) {
    area += relative_area(part.shell);
    for (const LonLatLine& hole : part.holes) area -= relative_area(hole);
  }
  return area;
}

}  // namespace

std::string_view name_of(Status status) {
  switch (status) {
    case Status::planned:
      return "planned";
    case Status::partial:
      return "partial";
    case Status::refused:
      return "refused";
  }
  return {};
}

Status status_of(const BlockReport& block) {
  if (!block.refused.empty()) return Status::refused;
  return block.covered_m2 >= kPlannedShare * block.area_m2 ? Status::planned : Status::partial;
}

Status status_of(const Plan& plan) {
  const auto is_refused = [](const BlockReport& block) { return status_of(block) == Status::refused; };
  if (std::ranges::all_of(plan.blocks, is_refused)) return Status::refused;
  return status_of(total(plan.blocks));
}

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

BlockReport total(const std::vector<BlockReport>& blocks) {
  BlockReport all;
  for (const BlockReport& block : blocks) {
    all.area_m2 += block.area_m2;
    all.covered_m2 += block.covered_m2;
    all.twice.last_strip_m2 += block.twice.last_strip_m2;
    all.twice.wedges_m2 += block.twice.wedges_m2;
    all.twice.corners_m2 += block.twice.corners_m2;
    all.twice.pockets_m2 += block.twice.pockets_m2;
    all.uncovered.insert(all.uncovered.end(), block.uncovered.begin(), block.uncovered.end());
    all.swaths += block.swaths;
    all.pieces += block.pieces;
    all.work_m += block.work_m;
    all.turn_m += block.turn_m;
    all.transfer_m += block.transfer_m;
    all.reverse_m += block.reverse_m;
    all.work_s += block.work_s;
    all.turn_s += block.turn_s;
    all.transfer_s += block.transfer_s;
    all.turns += block.turns;
    all.transfers += block.transfers;
    all.pivots += block.pivots;
    all.scrub_m += block.scrub_m;
  }
  return all;
}

double driven_m(const BlockReport& block) { return block.work_m + block.turn_m + block.transfer_m; }
double driven_s(const BlockReport& block) { return block.work_s + block.turn_s + block.transfer_s; }

double uncovered_m2(const std::vector<BlockReport>& blocks) {
  double area = 0;
  for (const BlockReport& block : blocks)
    area += block.area_m2 - (status_of(block) == Status::refused ? 0 : block.covered_m2);
  return area;
}

std::optional<SwathLengths> swath_lengths(const PlanFile& file, std::optional<int> block) {
  SwathLengths found{nullptr, nullptr};
  for (const SwathRecord& swath : file.swaths) {
    const bool counts = swath.order > 0 && !swath.id.starts_with('P') && (!block || swath.block == *block);
    if (!counts) continue;
    if (found.shortest == nullptr || swath.length_m < found.shortest->length_m) found.shortest = &swath;
    if (found.longest == nullptr || swath.length_m > found.longest->length_m) found.longest = &swath;
  }
  if (found.shortest == nullptr) return std::nullopt;
  return found;
}

double headland_m2(const PlanFile& file) {
  double headland = 0;
  for (const HeadlandRecord& band : file.headlands) headland += relative_area(band.parts);
  double field = 0;
  double field_m2 = 0;
  for (const FieldRecord& record : file.fields) {
    field += relative_area(record.parts);
    field_m2 += record.area_m2;
  }
  return field > 0 ? headland / field * field_m2 : 0;
}

}  // namespace selion
