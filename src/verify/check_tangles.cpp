// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "check.hpp"
#include "segments.hpp"

namespace selion::verifying {
namespace {

constexpr int kMostCrossings = 1000;  // rounding leaves a few where a border all but touches itself
constexpr int kMostBeside = 400'000;  // pairs of sides: more than of any field's border, see input.md,
constexpr int kBesideEach = 40;       // and so many of each side

/// Does its border cross itself so often that it encloses nothing in particular? To sort that out takes long.
bool is_tangle(const Plane& plane, const LonLatArea& area) {
  std::vector<std::vector<Point>> rings{plane.to_local(area.shell)};
  for (const LonLatLine& hole : area.holes) rings.push_back(plane.to_local(hole));
  int beside = kMostBeside;
  for (std::vector<Point>& ring : rings) {
    beside += kBesideEach * static_cast<int>(ring.size());
    for (const Point p : ring)
      if (!std::isfinite(p.x_m) || !std::isfinite(p.y_m)) return true;
    if (!ring.empty()) ring.push_back(ring.front());
  }
  return Segments{rings}.tangled(kMostCrossings, beside);
}

bool check_parts(Case& plan, int block, const std::vector<LonLatArea>& parts, const std::string& what) {
  bool sound = true;
  for (const LonLatArea& part : parts) {
    if (!is_tangle(plan.plane, part)) continue;
    plan.findings.add("field_shape", block, plan.plane.to_local(part.shell.front()), {0, kMostCrossings},
                      what + " crosses itself more than " + std::to_string(kMostCrossings) +
                          " times, runs to and fro as none does, or lies nowhere; the plan is not checked "
                          "further");
    sound = false;
  }
  return sound;
}

}  // namespace

bool check_tangles(Case& plan) {
  const PlanFile& file = plan.plan;
  bool sound = true;
  for (const FieldRecord& field : file.fields)
    sound = check_parts(plan, 0, field.parts, "the border of the field") && sound;
  for (const ObstacleRecord& obstacle : file.obstacles)
    sound = check_parts(plan, obstacle.block, {obstacle.area}, "the border of an obstacle") && sound;
  for (const HeadlandRecord& headland : file.headlands)
    sound = check_parts(plan, headland.block, headland.parts, "the border of the headland") && sound;
  for (const CellRecord& cell : file.cells)
    sound = check_parts(plan, cell.block, cell.parts, "the border of a cell") && sound;
  return sound;
}

}  // namespace selion::verifying
