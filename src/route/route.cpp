// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/route/route.hpp"

#include <algorithm>
#include <map>
#include <numbers>

#include "driver.hpp"
#include "selion/core/format.hpp"
#include "work.hpp"

namespace selion {
namespace {

constexpr double kGateRoom_m = 0.05;  // between the body and the border at the gate

std::string called(const BlockGate& gate) { return gate.name.empty() ? "the gate" : "gate " + gate.name; }

/// `room_m` inside the gate; absent where the machine does not fit there.
std::optional<Pose> at_gate(const Driver& driver, const BlockGate& gate, double room_m, double heading_rad) {
  const Pose pose{gate.at + (room_m + kGateRoom_m) * unit(gate.inward_rad), heading_rad};
  if (!fits(driver.terrain().space, driver.terrain().footprint, pose)) return std::nullopt;
  return pose;
}

std::optional<Pose> entry_at(const Driver& driver, const BlockGate& gate) {
  const Machine& machine = driver.machine();
  return at_gate(driver, gate, std::max(machine.rear_m, -machine.tool_x_m), gate.inward_rad);
}

std::optional<Pose> exit_at(const Driver& driver, const BlockGate& gate) {
  const Machine& machine = driver.machine();
  return at_gate(driver, gate, std::max(machine.front_m, machine.tool_x_m),
                 gate.inward_rad + std::numbers::pi);
}

std::optional<Infeasible> too_narrow(const BlockGate& gate, const Machine& machine) {
  if (!gate.width_m || *gate.width_m >= machine.body_width_m) return std::nullopt;
  return Infeasible{called(gate) + " is " + fixed(*gate.width_m, 2) + " m wide, the machine's body " +
                    fixed(machine.body_width_m, 2) + " m"};
}

void work_all(Work& work, HeadlandOrder headland, const BlockGate* gate, const Progress& progress) {
  if (headland == HeadlandOrder::first) work.headland_inwards();
  work.swaths(progress);
  work.pockets();
  if (headland == HeadlandOrder::last)
    work.headland_outwards(gate == nullptr ? std::nullopt : std::optional{gate->at});
  work.put_off();
}

void enter(Driver& driver, const BlockGate& gate, std::vector<std::string>& notes) {
  driver.stand_at(entry_at(driver, gate));
  if (!driver.here())
    notes.push_back("the machine does not fit inside " + called(gate) +
                    " square to the border; the drive starts elsewhere");
}

void leave(Driver& driver, const BlockGate& gate, std::vector<std::string>& notes) {
  const auto out = exit_at(driver, gate);
  if (out && !driver.drive_out_to(*out))
    notes.push_back("no way back to " + called(gate) + " was found; the drive ends elsewhere");
}

bool works_a_swath(const std::vector<RoutePiece>& pieces) {
  return std::any_of(pieces.begin(), pieces.end(),
                     [](const RoutePiece& piece) { return piece.kind == PieceKind::swath; });
}

/// The parts of a headland pass that was split: H1a, H1b, ... in driving order, those left out last.
void name_parts(Route& route) {
  std::map<std::string, std::vector<std::string*>> parts;
  for (RoutePiece& piece : route.pieces)
    if (piece.kind == PieceKind::headland_pass) parts[piece.ref].push_back(&piece.ref);
  for (std::string& id : route.left_out)
    if (id.front() == 'H') parts[id].push_back(&id);
  for (auto& [pass, ids] : parts)
    for (std::size_t i = 0; ids.size() > 1 && i < ids.size(); ++i) *ids[i] += letters_of(i);
}

}  // namespace

Result<Route> route(const Block& block, const Layout& layout, const Machine& machine,
                    const RouteOptions& options, const Progress& progress) {
  const BlockGate* gate = options.gate ? &block.gates[*options.gate] : nullptr;
  if (gate != nullptr)
    if (const auto why = too_narrow(*gate, machine)) return *why;
  Driver driver{block, layout, machine};
  std::vector<std::string> notes;
  if (gate != nullptr) enter(driver, *gate, notes);
  Work work{driver, layout};
  work_all(work, options.headland, gate, progress);
  if (!works_a_swath(driver.driven()))
    return Infeasible{"the machine reaches no swath of this block: there is no room to turn into one"};
  if (gate != nullptr) leave(driver, *gate, notes);
  Route route{driver.driven(), work.left(), std::move(notes)};
  name_parts(route);
  return route;
}

}  // namespace selion
