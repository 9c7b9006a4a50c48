// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "selion/motion/standing.hpp"
#include "selion/motion/timed_turn.hpp"

namespace selion {
namespace {

constexpr double kCreep_mps = 0.1;  // slower than this the machine rather stands

std::string name_of(PieceKind kind) {
  switch (kind) {
    case PieceKind::swath:
      return "swath";
    case PieceKind::headland_pass:
      return "headland_pass";
    case PieceKind::turn:
      return "turn";
    case PieceKind::transfer:
      return "transfer";
  }
  return {};
}

bool works(PieceKind kind) { return kind == PieceKind::swath || kind == PieceKind::headland_pass; }

bool straight_ahead(const Stretch& stretch) {
  return stretch.gear == Gear::forward && !is_pivot(stretch) && is_straight(stretch.curve);
}

/// Adds pieces in order and keeps account of the tool. Times are taken at the caps: the drive is never
/// faster, so the tool has at least these.
class Pieces {
 public:
  explicit Pieces(const Machine& machine) : machine_{machine} {}

  void work(const RoutePiece& piece) {
    if (!down_) stand(start_pose(piece.path), missing_s_.value_or(rising_s_ + machine_.tool_lower_s));
    missing_s_.reset();
    rising_s_ = 0;
    down_ = true;
    for (const Stretch& stretch : piece.path) add(piece, stretch, machine_.work_speed_mps);
  }

  /// Where `next` is work, the last stretch of the way to it may be the run-in.
  void way(const RoutePiece& piece, const RoutePiece* next) {
    rise();
    for (std::size_t i = 0; i < piece.path.size(); ++i) {
      const Stretch& stretch = piece.path[i];
      if (i > 0) steer(piece.path[i - 1], stretch);
      const bool last = i + 1 == piece.path.size() && next != nullptr && works(next->kind);
      if (last && machine_.run_in_m > 0 && straight_ahead(stretch))
        run_in(piece, stretch);
      else
        pass(piece, stretch);
    }
  }

  std::vector<DrivePiece> end(const Pose& at) && {
    rise();
    stand(at, rising_s_);
    return std::move(pieces_);
  }

 private:
  void rise() {
    if (down_) rising_s_ = machine_.tool_raise_s;
    down_ = false;
  }

  void pass(const RoutePiece& piece, const Stretch& stretch) {
    if (stretch.gear == Gear::reverse || is_pivot(stretch))
      stand(vehicle_pose(stretch, 0), std::exchange(rising_s_, 0));
    if (is_pivot(stretch)) return pivot(piece, stretch);
    const double cap = turn_cap_mps(machine_, stretch.curve);
    add(piece, stretch, cap);
    rising_s_ = std::max(0.0, rising_s_ - stretch.curve.length_m / cap);
  }

  void pivot(const RoutePiece& piece, const Stretch& stretch) {
    pieces_.push_back({{stretch, 0, down_, pivot_s(machine_, stretch.pivot_rad)}, "pivot", piece.ref});
  }

  void steer(const Stretch& before, const Stretch& after) {
    const double wait_s = steering_s(machine_, before, after);
    if (wait_s > 0) pieces_.push_back({{standing_after(before), 0, false, wait_s}, "wait", ""});
    rising_s_ = std::max(0.0, rising_s_ - wait_s);
  }

  /// Where the straight is longer than what was asked for, the tool comes down at its end.
  void run_in(const RoutePiece& piece, const Stretch& stretch) {
    const double needed_s = rising_s_ + machine_.tool_lower_s;
    const double length = std::min(stretch.curve.length_m, machine_.run_in_m);
    const double cap = turn_cap_mps(machine_, stretch.curve);
    const bool rolls = length >= needed_s * kCreep_mps;
    missing_s_ = rolls ? 0 : std::max(0.0, needed_s - length / cap);
    add(piece, stretch, rolls && needed_s > 0 ? std::min(cap, length / needed_s) : cap);
  }

  void add(const RoutePiece& piece, const Stretch& stretch, double cap_mps) {
    pieces_.push_back({{stretch, cap_mps, down_, 0}, name_of(piece.kind), piece.ref});
  }

  void stand(const Pose& pose, double wait_s) {
    if (wait_s <= 0) return;
    const Curve here{pose.at, pose.heading_rad, 0, 0, 0};
    pieces_.push_back({{{here, Gear::forward}, 0, false, wait_s}, "wait", ""});
  }

  const Machine& machine_;
  std::vector<DrivePiece> pieces_;
  bool down_ = false;
  double rising_s_ = 0;              ///< until the tool is up
  std::optional<double> missing_s_;  ///< of lowering, at the end of a run-in
};

std::vector<DrivePiece> drive_pieces(const Route& route, const Machine& machine) {
  if (route.pieces.empty()) return {};
  Pieces pieces{machine};
  for (std::size_t i = 0; i < route.pieces.size(); ++i) {
    const RoutePiece& piece = route.pieces[i];
    if (works(piece.kind))
      pieces.work(piece);
    else
      pieces.way(piece, i + 1 < route.pieces.size() ? &route.pieces[i + 1] : nullptr);
  }
  return std::move(pieces).end(end_pose(route.pieces.back().path));
}

}  // namespace

Drive drive_of(const Route& route, const Machine& machine) {
  std::vector<DrivePiece> pieces = drive_pieces(route, machine);
  std::vector<Leg> legs;
  legs.reserve(pieces.size());
  for (const DrivePiece& piece : pieces) legs.push_back(piece.leg);
  return {std::move(pieces), drive(legs, machine)};
}

}  // namespace selion
