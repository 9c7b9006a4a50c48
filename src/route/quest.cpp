// SPDX-License-Identifier: GPL-3.0-or-later
#include "quest.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace selion {
namespace {

constexpr std::size_t kMostVisited = 40000;
constexpr std::size_t kSoon = 60;             // visited
constexpr std::size_t kMostInVain = 300;      // where no road leads to a goal
constexpr double kLeapsLater = 1.5;           // weight of a turn from afar straight to a goal
constexpr double kTurnsLater = 3;             // radii: a turn must promise so much more than driving on
constexpr double kFar = 2;                    // reaches: further off, dearer ground counts
constexpr double kVeryFar = 8;                // reaches: there it counts from the first
constexpr double kLong = 5;                   // reaches: a way that costs so much is searched for with care
constexpr double kWellFound = 1.15;           // unless it costs no more than so many times the least
constexpr std::size_t kMostWithCare = 10000;  // visited
constexpr double kGuideCells = 150;           // a side

Link known_link(std::size_t to, const Path& path, double cost_m) {
  Link link;
  link.to = to;
  link.path = path;
  link.cost_m = cost_m;
  link.least_m = cost_m;
  link.worked_out = true;
  return link;
}

}  // namespace

Quest::Quest(Roads& roads, const Pose& from, const std::vector<Pose>& goals,
             const std::vector<Path>& retreats)
    : roads_{roads}, terrain_{roads.terrain()}, goals_{goals} {
  add_start(from, {});
  for (const Path& retreat : retreats) add_start(end_pose(retreat), retreat);
  for (std::size_t g = 0; g < goals.size(); ++g) add_ends(g);
  for (const End& end : ends_) entries_.push_back({end.pose, end.run_m});
  guide_beyond(kVeryFar);
}

/// Where a goal is further off than so many reaches.
void Quest::guide_beyond(double reaches) {
  const Pose& from = starts_.front().pose;
  if (!guide_ && crow_m(from.at) > reaches * roads_.reach_m())
    guide_.emplace(terrain_, from, goals_, std::numeric_limits<double>::infinity(), kGuideCells);
}

void Quest::add_start(const Pose& at, const Path& retreat) {
  const std::size_t node = roads_.size() + starts_.size();
  starts_.push_back({at, known_link(node, retreat, cost_m(terrain_, retreat)), std::nullopt});
}

const Pose& Quest::pose(std::size_t node) const {
  if (node < roads_.size()) return roads_.pose(node);
  return node < first_goal() ? starts_[node - roads_.size()].pose : goals_[node - first_goal()];
}

/// The most that is known of the way to go, weighted.
double Quest::rest_m(std::size_t node) {
  if (node >= first_goal()) return 0;
  const auto [known, is_new] = rest_m_.try_emplace(node, 0);
  if (!is_new) return known->second;
  const Pose& here = pose(node);
  const double guided_m = guide_ ? guide_->to_goal_m(here.at) : 0;
  return known->second = greed_ * std::max(dubins_m(here), std::isinf(guided_m) ? 0 : guided_m);
}

/// Far from where a search begins and ends, junctions are enough.
bool Quest::leaves_by_turns(std::size_t node) const {
  const Point at = roads_.pose(node).at;
  const double close_m = 2 * roads_.reach_m();
  return roads_.is_junction(node) || distance_m(at, starts_.front().pose.at) < close_m ||
         crow_m(at) < close_m;
}

/// A turn to an end, and what is driven from there.
Link Quest::link_into(const End& end, const Pose& from) const {
  Link link = link_between(terrain_, first_goal() + end.goal, from, end.pose);
  link.after = &end.run;
  link.least_m += end.run_m;
  return link;
}

/// To the goals, where near also to places to run into them from, and to the roads.
Roads::Links& Quest::turns_of(Start& start) {
  if (start.turns) return *start.turns;
  Roads::Links& turns = start.turns.emplace();
  for (const End& end : ends_)
    if (end.run.empty() || distance_m(start.pose.at, end.pose.at) <= roads_.reach_m())
      turns.push_back(link_into(end, start.pose));
  for (const std::size_t node : roads_.likely_after(start.pose))
    turns.push_back(link_between(terrain_, node, start.pose, roads_.pose(node)));
  return turns;
}

/// A turn from afar straight to a goal is one step: unweighted it would beat ways round by the headland that
/// cost less.
double Quest::rest_after_m(const Link& link) {
  const bool is_leap = link.to >= first_goal() && link.turn_m > kFar * roads_.reach_m();
  return is_leap ? (kLeapsLater - 1) * link.cost_m : rest_m(link.to);
}

void Quest::propose(std::size_t from, Link& link) {
  if (std::binary_search(shut_.begin(), shut_.end(), link.to)) return;
  const double later_m = link.worked_out ? 0 : kTurnsLater / terrain_.limits.curvature_per_m;
  frontier_.propose(from, link, rest_m(link.to) + later_m);
}

/// By all its links.
void Quest::leave(std::size_t node) {
  const auto propose_all = [&](Roads::Links& links) {
    for (Link& link : links) propose(node, link);
  };
  if (node >= roads_.size()) return propose_all(turns_of(starts_[node - roads_.size()]));
  propose_all(roads_.next_on_line(node));
  if (leaves_by_turns(node)) propose_all(roads_.turns_from(node));
  join_near(roads_.pose(node).at);
  if (const auto ends = to_ends_.find(node); ends != to_ends_.end())
    for (Link* link : ends->second) propose(node, *link);
}

/// Works out a proposed link and drives it, or leaves a node.
void Quest::expand(const Frontier::Entry& next) {
  if (next.link == nullptr) {
    if (!frontier_.outdated(next, rest_m(next.node))) leave(next.node);
  } else if (frontier_.promises(next)) {
    roads_.work_on(*next.link);
    if (!next.link->worked_out) return propose(next.node, *next.link);
    frontier_.drive(next.node, *next.link, rest_after_m(*next.link));
  }
}

/// A place to set out from need not have come up yet.
Path Quest::way_to(std::size_t node) const {
  if (node >= roads_.size() && node < first_goal()) return starts_[node - roads_.size()].retreat.path;
  Path way;
  for (const Link* link : frontier_.way_to(node)) append(way, at_its_fastest(terrain_, *link));
  return way;
}

Arrival Quest::arrival(std::size_t goal) const { return {goal - first_goal(), way_to(goal)}; }

/// Begins anew; what is worked out is kept. The goal that is reached.
std::optional<std::size_t> Quest::found(std::size_t most_visited) {
  frontier_ = {};
  rest_m_.clear();
  for (Start& start : starts_) propose(Frontier::kStart, start.retreat);
  for (std::size_t visited = 0; !frontier_.empty() && visited < most_visited; ++visited) {
    const Frontier::Entry next = frontier_.take();
    if (next.link == nullptr && next.node >= first_goal()) return next.node;
    expand(next);
  }
  return std::nullopt;
}

Roads::Stations Quest::stations_reached() const {
  Roads::Stations reached = frontier_.reached();
  reached.erase(std::lower_bound(reached.begin(), reached.end(), roads_.size()), reached.end());
  return reached;
}

/// By turns from where it sets out, and over other stations than those.
std::optional<std::size_t> Quest::found_beside(Roads::Stations shut) {
  shut_ = std::move(shut);
  const auto goal = found(kMostVisited);
  shut_.clear();
  return goal;
}

/// Most ways are found soon. Where one is not, the way left is taken from the ground and, where goals are
/// few, from the turns into them: else a search floods the roads around a goal that hardly any of them leads
/// to, or none from here.
std::optional<std::size_t> Quest::found() {
  if (const auto goal = found(kSoon)) return goal;
  realm_ = roads_.realm_of(stations_reached());
  if (realm_ != nullptr && goals_not_in_vain(*realm_).empty()) return found_beside(*realm_);
  guide_beyond(kFar);
  if (has_few_goals() && !find_entries()) {
    Roads::Stations all(roads_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const auto goal = found_beside(std::move(all));
    return goal ? goal : found(kMostInVain);
  }
  const auto goal = found(kMostVisited);
  if (!goal && frontier_.empty() && realm_ == nullptr) realm_ = roads_.remember_realm(stations_reached());
  return goal;
}

std::optional<Arrival> Quest::way() {
  auto goal = found();
  if (!goal) goal = frontier_.cheapest_from(first_goal());
  return goal ? or_cheaper(*goal) : beyond();
}

/// A search in a hurry may end with a way round by the far side, or over the mainland, that costs twice the
/// least.
Arrival Quest::or_cheaper(std::size_t goal) {
  Arrival first = arrival(goal);
  const double first_m = frontier_.cost_m(goal);
  const double least_m = dubins_m(starts_.front().pose);
  if (first_m < std::max(kLong * roads_.reach_m(), kWellFound * least_m + roads_.reach_m() / 2)) return first;
  if (!roads_.is_care_due()) return first;
  greed_ = 1;
  const auto other = found(kMostWithCare);
  const bool is_cheaper = other && frontier_.cost_m(*other) < first_m;
  roads_.remember_care(is_cheaper);
  return is_cheaper ? arrival(*other) : std::move(first);
}

}  // namespace selion
