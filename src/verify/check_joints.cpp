// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kJoint_m = 1e-6;
constexpr double kJoint_rad = 1e-6;
constexpr double kJoint_per_m = 1e-6;
constexpr double kRounded = 1e-9;  // of what two sums of the file's decimals may differ by

bool works(const PieceRecord& piece) { return piece.kind == "swath" || piece.kind == "headland_pass"; }

void check_joint(Case& plan, const Driven& driven, std::size_t i) {
  const PieceLine& a = driven.pieces[i - 1];
  const PieceLine& b = driven.pieces[i];
  const Spot end = a.spot(a.length_m());
  const Spot start = b.spot(0);
  const int block = driven.record->block;
  const double off = distance_m(end.at, start.at);
  if (!(off <= kJoint_m + kRounded))
    plan.findings.add(
        "joint_position", block, start.at, {off, kJoint_m},
        piece_name(driven, i) + " begins " + shown(off, 4) + " m off the end of the one before");
  const double points = a.vehicle(a.length_m()).heading_rad + a.record().angle_rad.value_or(0);
  const double turned = std::abs(std::remainder(points - b.vehicle(0).heading_rad, 2 * std::numbers::pi));
  if (!(turned <= kJoint_rad + kRounded))
    plan.findings.add("joint_heading", block, start.at, {turned, kJoint_rad},
                      piece_name(driven, i) + " begins turned by " + shown(turned, 6) + " rad");
  const bool rests = a.record().gear != b.record().gear || a.stands() || b.stands();
  const double bent = std::abs(end.curvature_per_m - start.curvature_per_m);
  if (!rests && !(bent <= kJoint_per_m))
    plan.findings.add(
        "joint_curvature", block, start.at, {bent, kJoint_per_m},
        "the curvature jumps by " + shown(bent, 6) + " 1/m where " + piece_name(driven, i) + " begins");
}

void check_tool(Case& plan, const Driven& driven, std::size_t i) {
  const PieceRecord& piece = driven.pieces[i].record();
  const int block = driven.record->block;
  const Point at = driven.pieces[i].spot(0).at;
  if (piece.tool == 1 && piece.gear < 0)
    plan.findings.add("tool_in_reverse", block, at, {1, 0}, piece_name(driven, i) + " works in reverse");
  if (works(piece) && piece.tool == 0)
    plan.findings.add("tool_up", block, at, {0, 1}, piece_name(driven, i) + " has its tool up");
  if (!works(piece) && piece.tool == 1)
    plan.findings.add("tool_down", block, at, {1, 0}, piece_name(driven, i) + " has its tool down");
}

/// The wheels of both sides from rest to rest over their way.
double least_pivot_s(const Machine& m, double angle_rad) {
  const double way = std::abs(angle_rad) * m.track_m / 2;
  const double slow = 1 / m.max_accel_mps2 + 1 / m.max_brake_mps2;
  const double top = m.turn_speed_mps;
  return way < top * top * slow / 2 ? std::sqrt(2 * way * slow) : way / top + top * slow / 2;
}

void check_manoeuvre(Case& plan, const Driven& driven, std::size_t i) {
  const PieceRecord& piece = driven.pieces[i].record();
  const Machine& machine = plan.vehicle.machine;
  const int block = driven.record->block;
  const Point at = driven.pieces[i].spot(0).at;
  const auto name = [&] { return piece_name(driven, i); };
  if (piece.gear < 0 && !machine.may_reverse)
    plan.findings.add("reverse", block, at, {1, 0}, name() + " reverses, which this machine may not");
  if (driven.pieces[i].stands() && piece.length_m != 0)
    plan.findings.add("standing", block, at, {piece.length_m, 0}, name() + " stands, but has a length");
  if (piece.kind != "pivot") return;
  if (machine.kind != MachineKind::differential || !machine.may_pivot)
    plan.findings.add("pivot", block, at, {1, 0}, name() + ": this machine may not pivot");
  const double least = least_pivot_s(machine, piece.angle_rad.value_or(0));
  const double given = piece.duration_s.value_or(0);
  if (given < least - 1e-3)
    plan.findings.add(
        "pivot_time", block, at, {given, least},
        name() + " rotates in " + shown(given, 2) + " s, the wheels need " + shown(least, 2) + " s");
}

}  // namespace

void check_joints(Case& plan, const Driven& driven) {
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
    if (i > 0) check_joint(plan, driven, i);
    check_tool(plan, driven, i);
    check_manoeuvre(plan, driven, i);
  }
}

void check_bends(Case& plan, const Driven& driven) {
  constexpr double kSlack = 1 + 1e-6;
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
    const PieceLine& piece = driven.pieces[i];
    const bool down = piece.record().tool == 1;
    const double limit = down ? plan.vehicle.most_working_curvature_per_m : plan.vehicle.most_curvature_per_m;
    const double bend = piece.most_curvature_per_m();
    if (bend <= limit * kSlack) continue;
    plan.findings.add("curvature", driven.record->block, piece.spot(0).at, {bend, limit},
                      piece_name(driven, i) + " bends with a radius of " + shown(1 / bend, 3) +
                          " m; the machine" + (down ? ", working," : "") + " needs " + shown(1 / limit, 3) +
                          " m");
  }
}

}  // namespace selion::verifying
