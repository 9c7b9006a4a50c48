// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kOnLine_m = 0.02;

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

/// The machine as it stands at a gate to come in or to leave: square to the border or askew, the gate
/// straight behind it or ahead, and no farther in than two bodies.
bool stands_at(const Machine& machine, const Pose& pose, Point gate) {
  constexpr double kAside_m = 0.02;
  constexpr double kFarthest = 2;
  constexpr double kRoom_m = 0.1;
  const double along = dot(gate - pose.at, unit(pose.heading_rad));
  const double aside = cross(unit(pose.heading_rad), gate - pose.at);
  const double reach =
      along > 0 ? std::max(machine.front_m, machine.tool_x_m) : std::max(machine.rear_m, -machine.tool_x_m);
  const double off = std::abs(along);
  return std::abs(aside) <= kAside_m && off >= reach &&
         off <= reach + kFarthest * machine.body_width_m + kRoom_m;
}

bool is_at(const Case& plan, const Driven& driven, const GateRecord& gate) {
  const Point at = plan.plane.to_local(gate.at);
  const Machine& machine = plan.vehicle.machine;
  const PieceLine& last = driven.pieces.back();
  return stands_at(machine, driven.pieces.front().vehicle(0), at) ||
         stands_at(machine, last.vehicle(last.length_m()), at);
}

/// Where the machine does not fit at its gate, it begins elsewhere, but not at another one.
void check_driven_through(Case& plan, const GateRecord& gate) {
  for (const Driven& driven : plan.drives) {
    if (driven.record->block != gate.block || is_at(plan, driven, gate)) continue;
    for (const GateRecord& other : plan.plan.gates)
      if (other.block == gate.block && is_at(plan, driven, other))
        plan.findings.add("gate", gate.block, plan.plane.to_local(other.at), {},
                          "the drive begins or ends at " + gate_name(other) + "; by the job that is " +
                              gate_name(gate) + ", where it does neither");
  }
}

/// By its number among all gates; null where there is none.
const GateRecord* named_gate(const Case& plan) {
  const std::string& start = plan.vehicle.work.start;
  for (std::size_t i = 0; i < plan.plan.gates.size(); ++i)
    if (start == "gate:" + std::to_string(i + 1)) return &plan.plan.gates[i];
  return nullptr;
}

/// The gates that the machine may drive through: one a block, the first where the job names none of it.
std::map<int, const GateRecord*> gates_used(const Case& plan) {
  std::map<int, const GateRecord*> used;
  if (const GateRecord* named = named_gate(plan)) used.emplace(named->block, named);
  for (const GateRecord& gate : plan.plan.gates) used.try_emplace(gate.block, &gate);
  return used;
}

/// The gate that the job names is there, and those used are wide enough.
void check_start(Case& plan) {
  for (const auto& [block, gate] : gates_used(plan)) {
    check_width(plan, *gate);
    check_driven_through(plan, *gate);
  }
  const std::string& start = plan.vehicle.work.start;
  if (!start.empty() && named_gate(plan) == nullptr)
    plan.findings.add("gate", 0, std::nullopt, {},
                      "the drive is to start at " + start + "; the plan has no such gate");
}

}  // namespace

void check_gates(Case& plan) {
  for (const GateRecord& gate : plan.plan.gates) check_gate(plan, gate);
  check_start(plan);
}

}  // namespace selion::verifying
