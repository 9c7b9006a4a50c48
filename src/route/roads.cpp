// SPDX-License-Identifier: GPL-3.0-or-later
#include "roads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr std::size_t kTurnsTried = 10;  // from or to one place
constexpr int kOfOneLine = 2;
constexpr std::size_t kMostVisited = 100000;
constexpr double kGreed = 1.3;             // weight of the distance to go: within this factor of the best
constexpr std::size_t kBackedInto = 4;     // goals: of more, some can be driven into forwards
constexpr double kFarthestBeyond_m = 150;  // of a straight run backwards into a pose
constexpr double kFar = 8;                 // reaches: further off, dearer ground counts
constexpr double kGuideCells = 150;  // a side: fine enough to tell headland from mainland on a large field
constexpr std::size_t kNoTrack = std::numeric_limits<std::size_t>::max();

long long cell_key(double x, double y) {
  return (static_cast<long long>(x) << 32) ^ (static_cast<long long>(y) & 0xffffffffLL);
}

/// Roughly what a turn from `from` to `to` takes: the chord, and an arc for each change of heading on the
/// way.
double guess_m(const Pose& from, const Pose& to, double radius_m) {
  const Point chord = to.at - from.at;
  const double bearing = length_m(chord) > 0 ? heading_rad(chord) : from.heading_rad;
  return length_m(chord) + radius_m * (std::abs(wrapped(bearing - from.heading_rad)) +
                                       std::abs(wrapped(to.heading_rad - bearing)));
}

auto place_of(const std::vector<std::pair<double, std::size_t>>& ranked, std::size_t node) {
  return std::find_if(ranked.begin(), ranked.end(),
                      [node](const auto& entry) { return entry.second == node; });
}

}  // namespace

Roads::Roads(const Terrain& terrain, std::vector<Track> tracks)
    : terrain_{terrain},
      tracks_{std::move(tracks)},
      reach_m_{5 / terrain.limits.curvature_per_m + 3 * terrain.footprint.half_tool_m} {
  for (std::size_t t = 0; t < tracks_.size(); ++t)
    for (std::size_t s = 0; s < tracks_[t].stations.size(); ++s) {
      const Point at = tracks_[t].stations[s].pose.at;
      cells_[cell_key(std::floor(at.x_m / reach_m_), std::floor(at.y_m / reach_m_))].push_back(nodes_.size());
      nodes_.push_back({t, s});
    }
}

const Pose& Roads::pose(std::size_t node) const {
  return tracks_[nodes_[node].track].stations[nodes_[node].station].pose;
}

/// Within reach_m of p.
std::vector<std::size_t> Roads::near(Point p) const {
  std::vector<std::size_t> found;
  const double x = std::floor(p.x_m / reach_m_);
  const double y = std::floor(p.y_m / reach_m_);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const auto cell = cells_.find(cell_key(x + dx, y + dy));
      if (cell == cells_.end()) continue;
      for (const std::size_t node : cell->second)
        if (distance_m(pose(node).at, p) <= reach_m_) found.push_back(node);
    }
  std::sort(found.begin(), found.end());
  return found;
}

/// Those near `at` and not on `but_track` of which guess(node) is least, but few of any one line: else the
/// many swath ends crowd out the one headland pass beside them. No guess is below the distance.
template <class Guess>
std::vector<std::size_t> Roads::likely(Point at, std::size_t but_track, Guess guess) const {
  constexpr std::size_t kAtOnce = 32;
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (const std::size_t node : near(at))
    if (nodes_[node].track != but_track) by_distance.emplace_back(distance_m(pose(node).at, at), node);
  std::vector<std::pair<double, std::size_t>> ranked;
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < by_distance.size();) {
    const std::size_t end = std::min(i + kAtOnce, by_distance.size());
    const auto first = by_distance.begin() + static_cast<std::ptrdiff_t>(i);
    std::partial_sort(first, first + static_cast<std::ptrdiff_t>(end - i), by_distance.end());
    for (; i < end; ++i) ranked.emplace_back(guess(pose(by_distance[i].second)), by_distance[i].second);
    std::sort(ranked.begin(), ranked.end());
    best = foremost(ranked);
    const auto last = best.size() < kTurnsTried ? ranked.end() : place_of(ranked, best.back());
    if (last != ranked.end() && by_distance[i - 1].first > last->first) break;  // so are all others
  }
  return best;
}

std::vector<std::size_t> Roads::foremost(const std::vector<std::pair<double, std::size_t>>& ranked) const {
  std::unordered_map<std::size_t, int> of_track;
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < ranked.size() && best.size() < kTurnsTried; ++i)
    if (++of_track[nodes_[ranked[i].second].track] <= kOfOneLine) best.push_back(ranked[i].second);
  return best;
}

/// Stations of other lines that a turn from the pose probably reaches soonest.
std::vector<std::size_t> Roads::likely_after(const Pose& from, std::size_t but_track) const {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  return likely(from.at, but_track, [&](const Pose& to) { return guess_m(from, to, radius_m); });
}

/// Stations from which a turn probably reaches the pose soonest.
std::vector<std::size_t> Roads::likely_before(const Pose& to) const {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  return likely(to.at, kNoTrack, [&](const Pose& from) { return guess_m(from, to, radius_m); });
}

/// To the next station of its own line, known at once; none where the line ends.
Roads::Links& Roads::next_on_line(std::size_t node) {
  const auto [known, is_new] = next_.try_emplace(node);
  const Track& track = tracks_[nodes_[node].track];
  const std::size_t here = nodes_[node].station;
  const bool last = here + 1 == track.stations.size();
  const std::size_t next = last ? node - here : node + 1;
  if (!is_new || (last && !track.closed) || next == node) return known->second;
  Link link = link_between(terrain_, next, pose(node), pose(next));
  link.path = part_of(track.path, track.stations[here].s_m, track.stations[nodes_[next].station].s_m);
  link.cost_m = cost_m(terrain_, link.path);
  link.worked_out = true;
  known->second.push_back(std::move(link));
  return known->second;
}

/// Far from where a search begins and ends, junctions are enough.
bool Roads::leaves_by_turns(Quest& quest, std::size_t node) const {
  const Track::Station& station = tracks_[nodes_[node].track].stations[nodes_[node].station];
  const double close_m = 2 * reach_m_;
  return station.is_junction || distance_m(station.pose.at, quest.from.at) < close_m ||
         rest_m(quest, node) < kGreed * close_m;
}

Roads::Links& Roads::turns_from(std::size_t node) {
  const auto [known, is_new] = turns_.try_emplace(node);
  if (is_new)
    for (const std::size_t other : likely_after(pose(node), nodes_[node].track))
      known->second.push_back(link_between(terrain_, other, pose(node), pose(other)));
  return known->second;
}

void Roads::add_starts(Quest& quest, const Pose& from, const std::vector<Path>& retreats) const {
  const auto add = [&](std::size_t node, const Pose& at, const Pose& next, const Path* retreat) {
    Link link = link_between(terrain_, node, at, next);
    link.before = retreat;
    if (retreat != nullptr) link.least_m += cost_m(terrain_, *retreat);
    quest.starts.push_back(std::move(link));
  };
  const auto add_all = [&](const Pose& at, const Path* retreat) {
    for (std::size_t g = 0; g < quest.goals.size(); ++g) add(nodes_.size() + g, at, quest.goals[g], retreat);
    for (const std::size_t node : likely_after(at, kNoTrack)) add(node, at, pose(node), retreat);
  };
  add_all(from, nullptr);
  for (const Path& retreat : retreats) add_all(end_pose(retreat), &retreat);
}

std::vector<Path> Roads::runs_back_into(const Pose& to) const {
  std::vector<Path> runs;
  if (!terrain_.may_reverse) return runs;
  const double step_m = 2 / terrain_.limits.curvature_per_m;
  for (int k = 1; k * step_m < kFarthestBeyond_m; ++k) {
    Path run{{line(to.at + k * step_m * unit(to.heading_rad), to.at), Gear::reverse}};
    if (!fits(terrain_.space, terrain_.footprint, run)) break;
    runs.push_back(std::move(run));
  }
  return runs;
}

void Roads::add_ends(Quest& quest, std::size_t goal) const {
  const auto add = [&](const Pose& end, const Path* run) {
    for (const std::size_t node : likely_before(end)) {
      Link link = link_between(terrain_, nodes_.size() + goal, pose(node), end);
      link.after = run;
      if (run != nullptr) link.least_m += cost_m(terrain_, *run);
      quest.ends[node].push_back(std::move(link));
    }
  };
  add(quest.goals[goal], nullptr);
  for (const Path& run : quest.runs_back[goal]) add(start_pose(run), &run);
}

double Roads::crow_m(const Pose& from, const std::vector<Pose>& goals) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Pose& goal : goals) least_m = std::min(least_m, distance_m(from.at, goal.at));
  return least_m;
}

/// By the guide, or as the crow flies to the nearest goal, times kGreed.
double Roads::rest_m(Quest& quest, std::size_t node) const {
  if (node >= nodes_.size()) return 0;
  const auto [known, is_new] = quest.rest_m.try_emplace(node, 0);
  if (!is_new) return known->second;
  const Pose& here = pose(node);
  double rest_m = quest.guide ? quest.guide->to_goal_m(here.at) : crow_m(here, quest.goals);
  if (std::isinf(rest_m)) rest_m = crow_m(here, quest.goals);
  return known->second = kGreed * rest_m;
}

/// Works out a proposed link and drives it, or leaves a node by all its links.
void Roads::expand(Frontier& frontier, const Frontier::Entry& next, Quest& quest) {
  const auto propose = [&](Links& links) {
    for (Link& link : links) frontier.propose(next.node, link, rest_m(quest, link.to));
  };
  if (next.link != nullptr) {
    if (!frontier.promises(next)) return;
    work_out(terrain_, *next.link);
    frontier.drive(next.node, *next.link, rest_m(quest, next.link->to));
  } else if (!frontier.outdated(next, rest_m(quest, next.node))) {
    propose(next_on_line(next.node));
    if (leaves_by_turns(quest, next.node)) propose(turns_from(next.node));
    if (const auto end = quest.ends.find(next.node); end != quest.ends.end()) propose(end->second);
  }
}

/// Through the ground between the roads: from all places that they lead to.
std::optional<Arrival> Roads::beyond(const Pose& from, const Frontier& frontier,
                                     const std::vector<Pose>& goals,
                                     const std::vector<Path>& retreats) const {
  std::vector<Pose> departures{from};
  std::vector<Path> ways{{}};
  for (const Path& retreat : retreats) {
    departures.push_back(end_pose(retreat));
    ways.push_back(retreat);
  }
  const std::vector<std::size_t> reached = frontier.reached();
  for (const std::size_t node : reached) departures.push_back(pose(node));
  auto found = searched(terrain_, departures, goals);
  if (!found) return std::nullopt;
  Path whole = found->departure < ways.size() ? ways[found->departure]
                                              : frontier.way_to(reached[found->departure - ways.size()]);
  append(whole, found->arrival.way);
  return Arrival{found->arrival.goal, std::move(whole)};
}

/// Weighted A* (Pohl 1970).
std::optional<Arrival> Roads::way(const Pose& from, const std::vector<Pose>& goals,
                                  const std::vector<Path>& retreats) {
  Quest quest{from, goals, {}, {}, {}, {}, {}};
  if (crow_m(from, goals) > kFar * reach_m_)
    quest.guide.emplace(terrain_, from, goals, std::numeric_limits<double>::infinity(), kGuideCells);
  add_starts(quest, from, retreats);
  for (const Pose& goal : goals)
    quest.runs_back.push_back(goals.size() <= kBackedInto ? runs_back_into(goal) : std::vector<Path>{});
  for (std::size_t g = 0; g < goals.size(); ++g) add_ends(quest, g);
  Frontier frontier;
  for (Link& link : quest.starts) frontier.propose(Frontier::kStart, link, rest_m(quest, link.to));
  for (std::size_t visited = 0; !frontier.empty() && visited < kMostVisited; ++visited) {
    const Frontier::Entry next = frontier.take();
    if (next.link == nullptr && next.node >= nodes_.size())
      return Arrival{next.node - nodes_.size(), frontier.way_to(next.node)};
    expand(frontier, next, quest);
  }
  if (const auto goal = frontier.cheapest_from(nodes_.size()))
    return Arrival{*goal - nodes_.size(), frontier.way_to(*goal)};
  return beyond(from, frontier, goals, retreats);
}

}  // namespace selion
