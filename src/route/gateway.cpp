// SPDX-License-Identifier: GPL-3.0-or-later
#include "gateway.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "selion/core/units.hpp"

namespace selion {
namespace {

constexpr double kGateRoom_m = 0.05;  // between the body and the border at the gate
constexpr double kStepIn_m = 0.25;
constexpr double kFarthestIn = 2;  // bodies' widths
constexpr auto kAskew_deg = std::to_array({0, 15, -15, 30, -30, 45, -45, 60, -60, 75, -75});

/// Of the machine behind its axle, as it comes in; before it, as it goes out.
double reach_m(const Machine& machine, GateWay way) {
  return way == GateWay::in ? std::max(machine.rear_m, -machine.tool_x_m)
                            : std::max(machine.front_m, machine.tool_x_m);
}

}  // namespace

std::optional<AtGate> at_gate(const Terrain& terrain, const BlockGate& gate, GateWay way) {
  const double least_m = reach_m(terrain.machine, way) + kGateRoom_m;
  const double turned_rad = way == GateWay::in ? 0 : std::numbers::pi;
  const int steps = static_cast<int>(kFarthestIn * terrain.machine.body_width_m / kStepIn_m);
  for (int step = 0; step <= steps; ++step)
    for (const int askew_deg : kAskew_deg) {
      AtGate found{{}, radians_of_degrees(askew_deg), step * kStepIn_m};
      const double inward_rad = gate.inward_rad + found.askew_rad;
      found.pose = {gate.at + (least_m + found.further_in_m) * unit(inward_rad), inward_rad + turned_rad};
      if (fits(terrain.space, terrain.footprint, found.pose)) return found;
    }
  return std::nullopt;
}

std::string called(const BlockGate& gate) { return gate.name.empty() ? "the gate" : "gate " + gate.name; }

}  // namespace selion
