// SPDX-License-Identifier: GPL-3.0-or-later
#include "quest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "selion/motion/dubins.hpp"

namespace selion {
namespace {

constexpr std::size_t kMostVisited = 100000;
constexpr double kGreed = 1.6;             // weight of the distance to go: within this factor of the best
constexpr std::size_t kBackedInto = 4;     // goals: of more, some can be driven into forwards
constexpr double kFarthestBeyond_m = 150;  // of a straight run backwards into a pose
constexpr double kFar = 8;                 // reaches: further off, dearer ground counts
constexpr double kGuideCells = 150;  // a side: fine enough to tell headland from mainland on a large field

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
  if (crow_m(from.at) > kFar * roads.reach_m())
    guide_.emplace(terrain_, from, goals, std::numeric_limits<double>::infinity(), kGuideCells);
}

void Quest::add_start(const Pose& at, const Path& retreat) {
  const std::size_t node = roads_.size() + starts_.size();
  starts_.push_back({at, known_link(node, retreat, cost_m(terrain_, retreat)), std::nullopt});
}

void Quest::add_ends(std::size_t goal) {
  const Pose& to = goals_[goal];
  ends_.push_back({goal, to, {}, 0, false});
  if (!terrain_.may_reverse || goals_.size() > kBackedInto) return;
  const double step_m = 2 / terrain_.limits.curvature_per_m;
  for (int k = 1; k * step_m < kFarthestBeyond_m; ++k) {
    const Point begin = to.at + k * step_m * unit(to.heading_rad);
    const Point last = begin - step_m * unit(to.heading_rad);
    if (!fits(terrain_.space, terrain_.footprint, {{line(begin, last), Gear::reverse}})) break;
    Path run{{line(begin, to.at), Gear::reverse}};
    const double run_m = cost_m(terrain_, run);
    ends_.push_back({goal, start_pose(run), std::move(run), run_m, false});
  }
}

const Pose& Quest::pose(std::size_t node) const {
  if (node < roads_.size()) return roads_.pose(node);
  return node < first_goal() ? starts_[node - roads_.size()].pose : goals_[node - first_goal()];
}

double Quest::crow_m(Point at) const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Pose& goal : goals_) least_m = std::min(least_m, distance_m(at, goal.at));
  return least_m;
}

/// To the end that takes least, on the shortest way of bounded curvature.
double Quest::dubins_m(const Pose& at) const {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  double least_m = std::numeric_limits<double>::infinity();
  for (const End& end : ends_)
    if (distance_m(at.at, end.pose.at) + end.run_m < least_m)
      least_m = std::min(least_m, dubins_length_m(at, end.pose, radius_m) + end.run_m);
  return least_m;
}

/// The most that is known of the way to go, times kGreed.
double Quest::rest_m(std::size_t node) {
  if (node >= first_goal()) return 0;
  const auto [known, is_new] = rest_m_.try_emplace(node, 0);
  if (!is_new) return known->second;
  const Pose& here = pose(node);
  const double guided_m = guide_ ? guide_->to_goal_m(here.at) : 0;
  return known->second = kGreed * std::max(dubins_m(here), std::isinf(guided_m) ? 0 : guided_m);
}

/// Far from where a search begins and ends, junctions are enough.
bool Quest::leaves_by_turns(std::size_t node) const {
  const Point at = roads_.pose(node).at;
  const double close_m = 2 * roads_.reach_m();
  return roads_.is_junction(node) || distance_m(at, starts_.front().pose.at) < close_m ||
         crow_m(at) < close_m;
}

/// To the goals, and to the roads.
Roads::Links& Quest::turns_of(Start& start) {
  if (start.turns) return *start.turns;
  Roads::Links& turns = start.turns.emplace();
  for (std::size_t g = 0; g < goals_.size(); ++g)
    turns.push_back(link_between(terrain_, first_goal() + g, start.pose, goals_[g]));
  for (const std::size_t node : roads_.likely_after(start.pose))
    turns.push_back(link_between(terrain_, node, start.pose, roads_.pose(node)));
  return turns;
}

void Quest::join(std::size_t end) {
  ends_[end].joined = true;
  for (const std::size_t node : roads_.likely_before(ends_[end].pose)) {
    Link link = link_between(terrain_, first_goal() + ends_[end].goal, roads_.pose(node), ends_[end].pose);
    link.after = &ends_[end].run;
    link.least_m += ends_[end].run_m;
    to_ends_[node].push_back(&end_links_.emplace_back(std::move(link)));
  }
}

/// The ends that stations here may be joined to: all within reach.
void Quest::join_near(Point at) {
  for (std::size_t i = 0; i < ends_.size(); ++i)
    if (!ends_[i].joined && distance_m(at, ends_[i].pose.at) <= roads_.reach_m()) join(i);
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
    work_out(terrain_, *next.link);
    frontier_.drive(next.node, *next.link, rest_m(next.link->to));
  }
}

Arrival Quest::arrival(std::size_t goal) const { return {goal - first_goal(), frontier_.way_to(goal)}; }

std::optional<Arrival> Quest::way() {
  for (Start& start : starts_) propose(Frontier::kStart, start.retreat);
  for (std::size_t visited = 0; !frontier_.empty() && visited < kMostVisited; ++visited) {
    const Frontier::Entry next = frontier_.take();
    if (next.link == nullptr && next.node >= first_goal()) return arrival(next.node);
    expand(next);
  }
  if (const auto goal = frontier_.cheapest_from(first_goal())) return arrival(*goal);
  return beyond();
}

/// Through the ground between the roads: from all places that they lead to.
std::optional<Arrival> Quest::beyond() {
  const std::vector<std::size_t> reached = frontier_.reached();
  if (roads_.searched_in_vain(goals_, reached)) return std::nullopt;
  std::vector<Pose> departures{starts_.front().pose};
  for (const std::size_t node : reached) departures.push_back(pose(node));
  auto found = searched(terrain_, departures, goals_);
  if (!found) {
    roads_.remember_in_vain(goals_, reached);
    return std::nullopt;
  }
  Path whole = found->departure == 0 ? Path{} : frontier_.way_to(reached[found->departure - 1]);
  append(whole, found->arrival.way);
  return Arrival{found->arrival.goal, std::move(whole)};
}

}  // namespace selion
