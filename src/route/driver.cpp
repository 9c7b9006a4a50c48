// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "retreats.hpp"
#include "selion/motion/dubins.hpp"
#include "selion/motion/leads.hpp"
#include "selion/motion/timed_turn.hpp"

namespace selion {
namespace {

constexpr double kNoBetter_m = 1e-6;
constexpr double kFarRound = 3;  // a way this many turns long is worth a search for a shorter one

/// Without stretches that are nothing but rounding.
Path without_crumbs(Path path) {
  constexpr double kCrumb_m = 5e-7;  // half of what joints may miss
  std::erase_if(
      path, [](const Stretch& stretch) { return stretch.curve.length_m < kCrumb_m && !is_pivot(stretch); });
  return path;
}

}  // namespace

Driver::Driver(const Block& block, const Layout& layout, const Machine& machine)
    : layout_{layout},
      machine_{machine},
      space_{free_space(block.free, footprint_of(machine))},
      mainland_{layout.mainland},
      terrain_{space_,
               footprint_of(machine),
               limits_at(machine, machine.turn_speed_mps),
               Swings{limits_at(machine, machine.turn_speed_mps)},
               machine.may_reverse,
               mainland_,
               machine} {}

/// Built when a way over them is first asked for: most fields need none.
Roads& Driver::roads() {
  if (!roads_) roads_.emplace(terrain_, tracks_of(layout_, machine_, terrain_));
  return *roads_;
}

/// The same turns larger: built when first asked for.
const Swings& Driver::swings(double wider) {
  if (wider == 1) return terrain_.swings;
  const auto known = wider_.find(wider);
  if (known != wider_.end()) return known->second;
  const CurveLimits& limits = terrain_.limits;
  const CurveLimits gentle{limits.curvature_per_m / wider, limits.sharpness_per_m2 / (wider * wider)};
  return wider_.emplace(wider, Swings{gentle}).first->second;
}

/// The same turns with sharper clothoids.
const Swings& Driver::slower_swings(double speed_mps) {
  return slower_.try_emplace(speed_mps, limits_at(machine_, speed_mps)).first->second;
}

/// Beyond this a way is a transfer.
double Driver::longest_turn_m() const {
  return 14 / terrain_.limits.curvature_per_m + 6 * terrain_.footprint.half_tool_m;
}

/// The pose `run_in_m` before the work begins: from there the tool is brought down on a straight line. Nearer
/// where the machine does not fit so far back.
Pose Driver::before(const Pose& start) const {
  constexpr std::array kShares{1.0, 0.75, 0.5, 0.25};
  if (machine_.run_in_m <= 0) return start;
  for (const double share : kShares) {
    const Point begin = start.at - share * machine_.run_in_m * unit(start.heading_rad);
    if (stays_inside(space_, terrain_.footprint, {{line(begin, start.at), Gear::forward}}))
      return {begin, start.heading_rad};
  }
  return start;
}

std::vector<Path> Driver::ways_back() const {
  return machine_.may_reverse ? retreats(driven_) : std::vector<Path>{};
}

void Driver::work(const Task& task, const Path& way, const Path& work) {
  const PieceKind kind = length_m(way) <= longest_turn_m() ? PieceKind::turn : PieceKind::transfer;
  if (Path clean = without_crumbs(way); !clean.empty()) driven_.push_back({kind, "", std::move(clean)});
  driven_.push_back({task.kind, task.id, without_crumbs(work)});
  here_ = end_pose(work);
}

/// The cheapest single turn within the limits, with what follows: those that can be short are worked out
/// first.
std::optional<Driver::Approach> Driver::turn_into(const std::vector<Goal>& goals, const Swings& swings,
                                                  double most_m, std::size_t most_goals) const {
  std::vector<std::pair<double, std::size_t>> ranked;
  const double radius_m = 1 / swings.limits().curvature_per_m;
  for (std::size_t i = 0; i < goals.size(); ++i)
    if (far_m(here_, goals[i].pose) <= longest_turn_m())  // further off the roads lead
      ranked.emplace_back(dubins_length_m(*here_, goals[i].pose, radius_m) + goals[i].rest_m, i);
  std::sort(ranked.begin(), ranked.end());
  ranked.resize(std::min(ranked.size(), most_goals));
  std::optional<Approach> best;
  double best_m = most_m;
  for (const auto& [least_m, i] : ranked) {
    if (best && least_m >= best_m) break;
    auto turn =
        direct_turn(terrain_, swings, *here_, goals[i].pose, best ? best_m - goals[i].rest_m : best_m);
    if (!turn) continue;
    const double cost = cost_m(terrain_, *turn);
    if (best && cost + goals[i].rest_m >= best_m - kNoBetter_m) continue;
    best_m = cost + goals[i].rest_m;
    best = Approach{i, std::move(*turn), cost};
  }
  return best;
}

/// By a tight turn to a gentle lead onto one of the nearest goals.
std::optional<Driver::Approach> Driver::turn_led_into(const std::vector<Goal>& goals) const {
  constexpr std::size_t kMostLed = 16;
  std::vector<Goal> beside;
  std::vector<std::pair<std::size_t, Path>> leads;
  for (std::size_t i = 0; i < std::min(kMostLed, goals.size()); ++i)
    for (Path& lead : leads_onto(goals[i].pose, terrain_.limits)) {
      if (!fits(space_, terrain_.footprint, lead)) continue;
      beside.push_back({start_pose(lead), goals[i].rest_m + cost_m(terrain_, lead)});
      leads.emplace_back(i, std::move(lead));
    }
  auto turn = turn_into(beside, terrain_.swings, longest_turn_m(), beside.size());
  if (!turn) return std::nullopt;
  const auto& [goal, lead] = leads[turn->goal];
  append(turn->way, lead);
  return Approach{goal, std::move(turn->way), turn->cost_m + cost_m(terrain_, lead)};
}

/// As tight as the machine can; else wider ones: the front of a long machine that turns tightly into a lane
/// at the border swings out over it. First to the likeliest goals: where those are out of reach of a tight turn,
/// so mostly are all others. Then by a lead; last, tight ones that are long.
std::optional<Driver::Approach> Driver::turn_into(const std::vector<Goal>& goals) {
  constexpr std::size_t kLikeliest = 12;
  for (const std::size_t most_goals : {kLikeliest, goals.size()})
    for (const double wider : {1.0, 2.0, 4.0, 8.0})
      if (auto turn = turn_into(goals, swings(wider), longest_turn_m(), most_goals)) return turn;
  if (auto turn = turn_led_into(goals)) return turn;
  return turn_into(goals, terrain_.swings, kFarRound * longest_turn_m(), goals.size());
}

/// At the highest speed below turn speed at which a turn needs no more room than there is.
std::optional<Driver::Approach> Driver::turn_slowly_into(const std::vector<Goal>& goals) {
  for (const double speed : turn_speeds(machine_)) {
    if (speed >= machine_.turn_speed_mps) continue;
    auto turn = turn_into(goals, slower_swings(speed), longest_turn_m(), goals.size());
    if (turn && turn->cost_m <= longest_turn_m()) return turn;
  }
  return std::nullopt;
}

std::optional<Driver::Approach> Driver::by(std::optional<Arrival> arrival) const {
  if (!arrival) return std::nullopt;
  const double cost = cost_m(terrain_, arrival->way);
  return Approach{arrival->goal, std::move(arrival->way), cost};
}

/// Where a goal lies straight ahead over ground that costs nothing more: no other way is shorter.
std::optional<Driver::Approach> Driver::straight_into(const std::vector<Goal>& goals) const {
  for (std::size_t i = 0; i < goals.size(); ++i) {
    auto way = straight_on(*here_, goals[i].pose);
    if (!way || goals[i].rest_m > 0 || !stays_inside(space_, terrain_.footprint, *way)) continue;
    const double cost = cost_m(terrain_, *way);
    if (cost <= length_m(*way) + kNoBetter_m) return Approach{i, std::move(*way), cost};
  }
  return std::nullopt;
}

/// The cheapest of: one turn; where that is a long one, the roads; where these lead a long way too, a turn at
/// lower speed; where they lead far round or nowhere, a search.
std::optional<Driver::Approach> Driver::approach(const std::vector<Goal>& goals) {
  if (auto straight = straight_into(goals)) return straight;
  std::optional<Approach> best = turn_into(goals);
  const auto keep_cheaper = [&best](std::optional<Approach> other) {
    if (other && (!best || other->cost_m < best->cost_m - kNoBetter_m)) best = std::move(other);
  };
  if (best && best->cost_m <= longest_turn_m()) return best;
  std::vector<Pose> poses(goals.size());
  std::transform(goals.begin(), goals.end(), poses.begin(), [](const Goal& goal) { return goal.pose; });
  keep_cheaper(by(roads().way(*here_, poses, ways_back())));
  const bool close = far_m(here_, poses.front()) < longest_turn_m();
  if (close && (!best || best->cost_m > longest_turn_m())) keep_cheaper(turn_slowly_into(goals));
  if (best && close && best->cost_m > kFarRound * longest_turn_m())
    if (auto found = searched(terrain_, {*here_}, poses)) keep_cheaper(by(std::move(found->arrival)));
  return best;
}

std::vector<Driver::Goal> Driver::goals_of(const Task& task) const {
  std::vector<Goal> goals;
  for (const Way& way : task.ways) goals.push_back({before(way.start), way.rest_m});
  return goals;
}

void Driver::drive_by(const Task& task, const std::vector<Goal>& goals, Approach approach) {
  const Way& chosen = task.ways[approach.goal];
  const Point begin = goals[approach.goal].pose.at;
  if (begin != chosen.start.at) approach.way.push_back({line(begin, chosen.start.at), Gear::forward});
  work(task, approach.way, path_of(task, chosen));
}

bool Driver::turn_to(const Task& task) {
  if (!here_ || task.ways.empty()) return false;
  const std::vector<Goal> goals = goals_of(task);
  auto turn = turn_into(goals, terrain_.swings, longest_turn_m(), goals.size());
  if (!turn || turn->cost_m > longest_turn_m()) return false;
  drive_by(task, goals, std::move(*turn));
  return true;
}

bool Driver::drive_to(const Task& task) {
  if (task.ways.empty()) return false;
  if (!here_) {
    work(task, {}, path_of(task, task.ways.front()));
    return true;
  }
  const std::vector<Goal> goals = goals_of(task);
  std::optional<Approach> best = approach(goals);
  if (!best) return false;
  drive_by(task, goals, std::move(*best));
  return true;
}

void Driver::drive_along(const Path& way, const Task& task) {
  work(task, way, path_of(task, task.ways.front()));
}

std::vector<RoutePiece> Driver::take_back() {
  const auto works = [](const RoutePiece& piece) {
    return piece.kind == PieceKind::swath || piece.kind == PieceKind::headland_pass;
  };
  std::size_t kept = driven_.size();
  while (kept > 0 && !works(driven_[kept - 1])) --kept;
  if (kept > 0) --kept;
  while (kept > 0 && !works(driven_[kept - 1])) --kept;
  if (kept == 0) return {};
  const auto first = driven_.begin() + static_cast<std::ptrdiff_t>(kept);
  std::vector<RoutePiece> taken(std::make_move_iterator(first), std::make_move_iterator(driven_.end()));
  driven_.erase(first, driven_.end());
  here_ = end_pose(driven_.back().path);
  return taken;
}

void Driver::drive_again(std::vector<RoutePiece> pieces) {
  driven_.insert(driven_.end(), std::make_move_iterator(pieces.begin()),
                 std::make_move_iterator(pieces.end()));
  here_ = end_pose(driven_.back().path);
}

bool Driver::drive_out_to(const Pose& goal) {
  std::optional<Approach> best = approach({{goal, 0}});
  if (!best) return false;
  if (Path clean = without_crumbs(std::move(best->way)); !clean.empty())
    driven_.push_back({PieceKind::transfer, "", std::move(clean)});
  here_ = goal;
  return true;
}

}  // namespace selion
