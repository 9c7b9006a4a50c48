// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/route/route.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "driver.hpp"
#include "gateway.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "work.hpp"

namespace selion {
namespace {

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

/// What a person who opens the gate must know.
std::string askew_note(const BlockGate& gate, const AtGate& there, const std::string& does) {
  return "the machine does not fit inside " + called(gate) + " square to the border: it " + does + " " +
         fixed(std::abs(degrees_of_radians(there.askew_rad)), 0) + " degrees askew, " +
         fixed(there.further_in_m, 2) + " m further in";
}

void enter(Driver& driver, const BlockGate& gate, Route& told) {
  const auto there = at_gate(driver.terrain(), gate, GateWay::in);
  if (!there) {
    told.warnings.push_back("the machine does not fit inside " + called(gate) +
                            "; the drive starts elsewhere");
    return;
  }
  if (!there->is_square()) told.notes.push_back(askew_note(gate, *there, "starts"));
  driver.stand_at(there->pose);
}

void leave(Driver& driver, const BlockGate& gate, Route& told) {
  const auto there = at_gate(driver.terrain(), gate, GateWay::out);
  if (!there)
    told.warnings.push_back("the machine does not fit inside " + called(gate) +
                            " on its way out; the drive ends elsewhere");
  else if (!driver.drive_out_to(there->pose))
    told.warnings.push_back("no way back to " + called(gate) + " was found; the drive ends elsewhere");
  else if (!there->is_square())
    told.notes.push_back(askew_note(gate, *there, "ends"));
}

/// A swath or pocket, where there is one; else a headland pass.
bool works_inside(const std::vector<RoutePiece>& pieces, const Layout& layout) {
  const bool has_inside = !layout.swaths.empty();
  return std::any_of(pieces.begin(), pieces.end(), [has_inside](const RoutePiece& piece) {
    return piece.kind == PieceKind::swath || (!has_inside && piece.kind == PieceKind::headland_pass);
  });
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

/// Swaths before the headland that is to be worked last, where any are reached.
bool in_order(const Route& route, HeadlandOrder headland) {
  if (headland != HeadlandOrder::last) return true;
  const auto is = [](PieceKind kind) {
    return [kind](const RoutePiece& piece) { return piece.kind == kind; };
  };
  const auto swath = std::find_if(route.pieces.begin(), route.pieces.end(), is(PieceKind::swath));
  return swath == route.pieces.end() ||
         std::none_of(route.pieces.begin(), swath, is(PieceKind::headland_pass));
}

const BlockGate* gate_of(const Block& block, const RouteOptions& options) {
  return options.gate ? &block.gates[*options.gate] : nullptr;
}

/// As `options` say; nothing is reached where no way leads on from the gate.
Result<Route> route_as_told(const Block& block, const Layout& layout, const Machine& machine,
                            const RouteOptions& options, const Progress& progress) {
  const BlockGate* gate = gate_of(block, options);
  Driver driver{block, layout, machine, *options.known};
  Route route;
  if (gate != nullptr) enter(driver, *gate, route);
  Work work{driver, layout};
  work_all(work, options.headland, gate, progress);
  if (!works_inside(driver.driven(), layout))
    return Infeasible{"the machine reaches no swath of this block: there is no room to turn into one"};
  if (gate != nullptr) leave(driver, *gate, route);
  route.pieces = driver.driven();
  route.left_out = work.left();
  name_parts(route);
  return route;
}

}  // namespace

std::shared_ptr<KnownGround> nothing_known() { return std::make_shared<KnownGround>(); }

Result<Route> route(const Block& block, const Layout& layout, const Machine& machine,
                    const RouteOptions& options, const Progress& progress) {
  const BlockGate* gate = gate_of(block, options);
  if (gate != nullptr)
    if (const auto why = too_narrow(*gate, machine)) return *why;
  auto routed = route_as_told(block, layout, machine, options, progress);
  if (gate == nullptr || (routed && in_order(*routed, options.headland))) return routed;
  RouteOptions anywhere = options;
  anywhere.gate.reset();
  auto elsewhere = route_as_told(block, layout, machine, anywhere, progress);
  if (!elsewhere || (routed && !in_order(*elsewhere, options.headland))) return routed;
  elsewhere->warnings.push_back("no way leads from " + called(*gate) +
                                " to the first swath; the drive starts and ends elsewhere");
  return elsewhere;
}

}  // namespace selion
