// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "driver.hpp"
#include "selion/motion/dubins.hpp"
#include "selion/motion/leads.hpp"
#include "selion/motion/timed_turn.hpp"

namespace selion {
namespace {

constexpr double kNoBetter_m = 1e-6;
constexpr double kFarRound = 3;  // a way this many turns long is worth a search for a shorter one

bool has_stops(const Path& path) {
  return std::any_of(path.begin(), path.end(),
                     [](const Stretch& s) { return s.gear == Gear::reverse || is_pivot(s); });
}

}  // namespace

/// The same turns larger: built when first asked for.
const Swings& Driver::swings(double wider) {
  if (wider == 1) return terrain_.swings;
  const auto known = wider_.find(wider);
  if (known != wider_.end()) return known->second;
  return wider_.emplace(wider, Swings{widened(terrain_.limits, wider)}).first->second;
}

/// The same turns with sharper clothoids.
const Swings& Driver::slower_swings(double speed_mps) {
  return slower_.try_emplace(speed_mps, limits_at(machine_, speed_mps)).first->second;
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
/// at the border swings out over it.
std::optional<Driver::Approach> Driver::turn_into(const std::vector<Goal>& goals, std::size_t most_goals) {
  for (const double wider : {1.0, 2.0, 4.0, 8.0})
    if (auto turn = turn_into(goals, swings(wider), longest_turn_m(), most_goals)) return turn;
  return std::nullopt;
}

/// To one of the likeliest goals: where those are out of reach of a turn, so mostly are all others. Else by a
/// lead.
std::optional<Driver::Approach> Driver::turn_into(const std::vector<Goal>& goals) {
  constexpr std::size_t kLikeliest = 12;
  if (auto turn = turn_into(goals, kLikeliest)) return turn;
  return turn_led_into(goals);
}

/// To any goal; last, by a long one.
std::optional<Driver::Approach> Driver::turn_anyhow_into(const std::vector<Goal>& goals) {
  if (auto turn = turn_into(goals, goals.size())) return turn;
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

/// Instead of a way with stops: forwards at a lower speed, which needs less room, or wider, where that takes
/// less.
Driver::Approach Driver::or_ahead(Approach way, const Pose& goal) {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  if (!has_stops(way.way) || far_m(here_, goal) > longest_turn_m()) return way;
  if (dubins_length_m(*here_, goal, radius_m) >= way.cost_m) return way;
  const auto finds = [&](const Swings& swings) {
    auto ahead = turn_ahead(terrain_, swings, *here_, goal, way.cost_m);
    if (!ahead) return false;
    const double cost = cost_m(terrain_, *ahead);
    if (cost < way.cost_m - kNoBetter_m) way = {way.goal, std::move(*ahead), cost};
    return true;
  };
  for (const double speed : turn_speeds(machine_))
    if (speed < machine_.turn_speed_mps && finds(slower_swings(speed))) break;
  for (const double wider : {2.0, 4.0, 8.0})
    if (finds(swings(wider))) break;
  return way;
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

/// One turn; where that is a long one, a turn at lower speed; where that is long too, the cheaper of the turn
/// and the roads; where there is none of all these, any turn; where the way leads far round, a search.
std::optional<Driver::Approach> Driver::approach(const std::vector<Goal>& goals) {
  if (auto straight = straight_into(goals)) return straight;
  std::optional<Approach> best = turn_into(goals);
  const auto keep_cheaper = [&best](std::optional<Approach> other) {
    if (other && (!best || other->cost_m < best->cost_m - kNoBetter_m)) best = std::move(other);
  };
  if (best && best->cost_m <= longest_turn_m()) return best;
  const bool close = far_m(here_, goals.front().pose) < longest_turn_m();
  if (close)
    if (auto slow = turn_slowly_into(goals)) return slow;
  std::vector<Pose> poses(goals.size());
  std::transform(goals.begin(), goals.end(), poses.begin(), [](const Goal& goal) { return goal.pose; });
  keep_cheaper(by(roads().way(*here_, poses, ways_back())));
  if (!best) best = turn_anyhow_into(goals);
  if (best && close && best->cost_m > kFarRound * longest_turn_m())
    keep_cheaper(shortcut(poses, best->cost_m));
  return best;
}

/// A way found by a search of the ground. Where there has been none at so many places in a row there is
/// hardly one at the next: then it looks for one at each 16th only.
std::optional<Driver::Approach> Driver::shortcut(const std::vector<Pose>& goals, double most_m) {
  constexpr unsigned kEachTime = 16;
  if (shortcuts_in_vain_ >= kEachTime && shortcuts_in_vain_ % kEachTime != 0) {
    ++shortcuts_in_vain_;
    return std::nullopt;
  }
  auto found = searched(terrain_, {*here_}, goals, roads().known_ground());
  auto way = found ? by(std::move(found->arrival)) : std::nullopt;
  shortcuts_in_vain_ = way && way->cost_m < most_m ? 0 : shortcuts_in_vain_ + 1;
  return way;
}

}  // namespace selion
