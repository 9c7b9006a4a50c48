// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_mutants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace selion {
namespace {

using Pieces = std::vector<PieceRecord>;

TrajectoryRecord* some_trajectory(PlanFile& plan, Dice& dice) {
  return plan.trajectories.empty() ? nullptr : &plan.trajectories[dice.pick(plan.trajectories.size())];
}

/// One of the pieces that suit.
template <class Suits>
PieceRecord* some_piece(PlanFile& plan, Dice& dice, Suits suits) {
  TrajectoryRecord* t = some_trajectory(plan, dice);
  std::vector<PieceRecord*> all;
  for (PieceRecord& piece : t->pieces)
    if (suits(piece)) all.push_back(&piece);
  return all.empty() ? nullptr : all[dice.pick(all.size())];
}

bool any(const PieceRecord& p) { return p.length_m > 0.5; }
bool works(const PieceRecord& p) { return p.tool == 1 && p.length_m > 1; }
bool turns(const PieceRecord& p) { return p.tool == 0 && p.length_m > 0.2; }
bool bends(const PieceRecord& p) {
  return p.length_m > 0.3 && (p.curvature_per_m != 0 || p.sharpness_per_m2 != 0);
}

template <class Suits, class Change>
std::function<bool(PlanFile&, Dice&)> to_piece(Suits suits, Change change) {
  return [=](PlanFile& plan, Dice& dice) {
    PieceRecord* piece = some_piece(plan, dice, suits);
    if (piece == nullptr) return false;
    change(*piece, dice);
    return true;
  };
}

double either(Dice& dice, double least, double most) {
  return dice.between(least, most) * (dice.pick(2) == 0 ? 1 : -1);
}

/// Where the pieces of one stint begin and end.
struct Range {
  std::size_t from;
  std::size_t to;
};
std::optional<Range> some_swath(const Pieces& pieces, Dice& dice) {
  std::vector<Range> all;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].kind != "swath") continue;
    std::size_t to = i;
    while (to < pieces.size() && pieces[to].ref == pieces[i].ref) ++to;
    all.push_back({i, to});
    i = to - 1;
  }
  if (all.empty()) return std::nullopt;
  return all[dice.pick(all.size())];
}

auto at(Pieces& pieces, std::size_t i) { return pieces.begin() + static_cast<std::ptrdiff_t>(i); }

bool drop_swath(PlanFile& plan, Dice& dice) {
  Pieces& pieces = some_trajectory(plan, dice)->pieces;
  const auto range = some_swath(pieces, dice);
  if (!range || range->from == 0 || range->to == pieces.size()) return false;
  pieces.erase(at(pieces, range->from), at(pieces, range->to));
  return true;
}

bool repeat_swath(PlanFile& plan, Dice& dice) {
  Pieces& pieces = some_trajectory(plan, dice)->pieces;
  const auto range = some_swath(pieces, dice);
  if (!range || range->to + 1 >= pieces.size()) return false;
  const Pieces again{at(pieces, range->from), at(pieces, range->to)};
  pieces.insert(at(pieces, range->to + 1), again.begin(), again.end());
  return true;
}

bool swap_swaths(PlanFile& plan, Dice& dice) {
  Pieces& pieces = some_trajectory(plan, dice)->pieces;
  const auto a = some_swath(pieces, dice);
  const auto b = some_swath(pieces, dice);
  if (!a || !b || a->from == b->from) return false;
  std::swap(pieces[a->from], pieces[b->from]);
  return true;
}

bool drop_piece(PlanFile& plan, Dice& dice) {
  Pieces& pieces = some_trajectory(plan, dice)->pieces;
  const std::size_t i = dice.pick(pieces.size());
  if (i == 0 || i + 1 == pieces.size() || pieces[i].length_m < 0.2) return false;
  pieces.erase(at(pieces, i));
  return true;
}

bool truncate_pieces(PlanFile& plan, Dice& dice) {
  Pieces& pieces = some_trajectory(plan, dice)->pieces;
  const std::size_t keep = 1 + dice.pick(pieces.size() - 1);
  double cut_m = 0;
  for (std::size_t i = keep; i < pieces.size(); ++i) cut_m += pieces[i].length_m;
  pieces.resize(keep);
  return cut_m > 0.1;
}

bool turn_back(PlanFile& plan, Dice& dice) {
  PieceRecord* piece = some_piece(plan, dice, turns);
  if (piece == nullptr) return false;
  piece->gear = -piece->gear;
  return true;
}

bool move_path(PlanFile& plan, Dice& dice) {
  const double east_m = either(dice, 0.1, 1);
  for (TrajectoryRecord& t : plan.trajectories) {
    for (PieceRecord& piece : t.pieces) piece.x_m += east_m;
    for (LonLat& p : t.line) p.lon_deg += east_m / 111320 / std::cos(p.lat_deg * 0.017453292519943295);
  }
  return true;
}

bool scale_path(PlanFile& plan, Dice& dice) {
  const double by = 1 + either(dice, 0.01, 0.1);
  for (TrajectoryRecord& t : plan.trajectories)
    for (PieceRecord& piece : t.pieces) {
      piece.x_m *= by, piece.y_m *= by, piece.length_m *= by;
      piece.curvature_per_m /= by, piece.sharpness_per_m2 /= by * by;
    }
  return true;
}

const std::vector<Mutation>& of_pieces() {
  static const std::vector<Mutation> all{
      {"shift a piece",
       {"joint_position"},
       to_piece(any, [](auto& p, Dice& d) { p.x_m += either(d, 1e-4, 1); })},
      {"turn a piece",
       {"joint_heading"},
       to_piece(any, [](auto& p, Dice& d) { p.heading_rad += either(d, 1e-5, 1); })},
      {"bend a piece",
       {"joint_curvature", "joint_heading", "joint_position"},
       to_piece(any, [](auto& p, Dice& d) { p.curvature_per_m += either(d, 1e-3, 0.1); })},
      {"bend beyond the limit",
       {"piece", "curvature"},
       to_piece(bends, [](auto& p, Dice& d) { p.curvature_per_m = 2 * d.between(1, 2); })},
      {"sharpen a piece",
       {"joint_curvature", "joint_heading", "joint_position"},
       to_piece(bends, [](auto& p, Dice& d) { p.sharpness_per_m2 += either(d, 1e-2, 0.1); })},
      {"lengthen a piece",
       {"joint_position", "not_finished"},
       to_piece(any, [](auto& p, Dice& d) { p.length_m += d.between(1e-3, 1); })},
      {"mirror a piece",
       {"joint_position", "joint_heading"},
       to_piece(bends, [](auto& p, Dice&) { p.curvature_per_m *= -1, p.sharpness_per_m2 *= -1; })},
      {"offset a piece",
       {"piece", "joint_position"},
       to_piece(any, [](auto& p, Dice& d) { p.offset_m = either(d, 0.01, 1); })},
      {"a length below 0", {"piece"}, to_piece(any, [](auto& p, Dice&) { p.length_m *= -1; })},
      {"numbers no machine drives",
       {"piece"},
       to_piece(any, [](auto& p, Dice&) { p.curvature_per_m = 1e5; })},
      {"raise the tool at work", {"tool_up"}, to_piece(works, [](auto& p, Dice&) { p.tool = 0; })},
      {"lower the tool in a turn", {"tool_down"}, to_piece(turns, [](auto& p, Dice&) { p.tool = 1; })},
      {"work in reverse", {"tool_in_reverse"}, to_piece(works, [](auto& p, Dice&) { p.gear = -1; })},
      {"reverse a turn", {"joint_heading"}, turn_back},
      {"work under another name", {"unknown_line"}, to_piece(works, [](auto& p, Dice&) { p.ref = "Z9"; })},
      {"drop a piece", {"joint_position", "joint_heading"}, drop_piece},
      {"drop a swath", {"not_driven"}, drop_swath},
      {"repeat a swath", {"driven_twice"}, repeat_swath},
      {"swap two swaths", {"joint_position"}, swap_swaths},
      {"truncate the pieces", {"not_driven", "not_finished", "sample_place", "summary"}, truncate_pieces},
      {"move the whole path", {"swath_line", "body_outside", "tool_outside"}, move_path},
      {"scale the whole path", {"sample_place", "swath_line"}, scale_path},
  };
  return all;
}

}  // namespace

std::uint64_t Dice::next() {  // SplitMix64 (Steele, Lea and Flood 2014)
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

std::size_t Dice::pick(std::size_t count) { return next() % count; }

double Dice::between(double low, double high) {
  return low + (high - low) * static_cast<double>(next() >> 11U) * 0x1p-53;
}

std::span<const Mutation> mutations_of_pieces() { return of_pieces(); }

}  // namespace selion
