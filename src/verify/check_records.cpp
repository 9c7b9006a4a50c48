// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kOnLine_m = 0.02;

/// Every record names a block that there is.
template <class Record>
void check_blocks(Case& plan, const std::vector<Record>& records, const std::string& kind) {
  for (const Record& record : records)
    if (plan.ground(record.block) == nullptr)
      plan.findings.add("block", 0, std::nullopt,
                        {1.0 * record.block, 1.0 * static_cast<double>(plan.grounds.size())},
                        kind + " is said to be of block " + std::to_string(record.block) +
                            "; the field has " + std::to_string(plan.grounds.size()));
}

std::string gate_name(const GateRecord& gate) { return gate.name.empty() ? "the gate" : "gate " + gate.name; }

void check_gate(Case& plan, const GateRecord& gate) {
  const Ground* ground = plan.ground(gate.block);
  if (ground == nullptr) return;
  const Point at = plan.plane.to_local(gate.at);
  const double off = Prepared{border_of(ground->area)}.distance_m(std::array{at});
  if (!(off <= kOnLine_m))
    plan.findings.add("gate", gate.block, at, {off, kOnLine_m},
                      gate_name(gate) + " lies " + shown(off, 2) + " m off the border of its block");
}

/// The one that the machine drives through.
void check_width(Case& plan, const GateRecord& gate) {
  const double body = plan.vehicle.machine.body_width_m;
  if (gate.width_m && !(*gate.width_m >= body))
    plan.findings.add("gate", gate.block, plan.plane.to_local(gate.at), {*gate.width_m, body},
                      gate_name(gate) + " is " + shown(*gate.width_m, 2) + " m wide, the machine's body " +
                          shown(body, 2) + " m");
}

bool is_whole(const Case& plan) {
  return std::ranges::all_of(plan.grounds, [&](const Ground& ground) {
    return std::ranges::any_of(plan.drives, [&](const Driven& d) { return d.record->block == ground.block; });
  });
}

/// The gates that the job lets the machine drive through: one a block, the first where it names none.
std::vector<const GateRecord*> gates_used(const Case& plan) {
  const std::string& start = plan.vehicle.work.start;
  const std::string wanted = start.starts_with("gate:") ? start.substr(5) : start;
  std::map<int, int> numbers;
  std::map<int, const GateRecord*> used;
  for (const GateRecord& gate : plan.plan.gates) {
    const std::string number = std::to_string(++numbers[gate.block]);
    if (start.empty() || gate.name == wanted || number == wanted) used.try_emplace(gate.block, &gate);
  }
  std::vector<const GateRecord*> gates;
  gates.reserve(used.size());
  for (const auto& [block, gate] : used) gates.push_back(gate);
  return gates;
}

/// The gate that the job names is there, unless it may belong to a block that is not planned, and is wide
/// enough.
void check_start(Case& plan) {
  const std::vector<const GateRecord*> used = gates_used(plan);
  for (const GateRecord* gate : used) check_width(plan, *gate);
  const std::string& start = plan.vehicle.work.start;
  if (!start.empty() && used.empty() && is_whole(plan))
    plan.findings.add("gate", 0, std::nullopt, {},
                      "the drive is to start at " + start + "; the plan has no such gate");
}

}  // namespace

void check_records(Case& plan) {
  const PlanFile& file = plan.plan;
  check_blocks(plan, file.obstacles, "an obstacle");
  check_blocks(plan, file.gates, "a gate");
  check_blocks(plan, file.cells, "a cell");
  check_blocks(plan, file.ab_lines, "an AB line");
  check_blocks(plan, file.headlands, "a headland");
  check_blocks(plan, file.headland_passes, "a headland pass");
  check_blocks(plan, file.swaths, "a swath");
  for (const GateRecord& gate : file.gates) check_gate(plan, gate);
  check_start(plan);
}

}  // namespace selion::verifying
