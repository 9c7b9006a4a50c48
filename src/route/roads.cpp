// SPDX-License-Identifier: GPL-3.0-or-later
#include "roads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontier.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr std::size_t kLinksTried = 10;  // turns tried from a station to other lines
constexpr std::size_t kJoinsTried = 10;  // stations tried for the first and the last turn
constexpr int kOfOneLine = 2;
constexpr std::size_t kMostVisited = 20000;
constexpr double kFarthestBeyond_m = 40;  // of a straight run backwards into a pose
constexpr double kFar = std::numeric_limits<double>::infinity();

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

Path joined(Path a, const Path& b, const Path& c) {
  append(a, b);
  append(a, c);
  return a;
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

const Track::Station& Roads::station(std::size_t node) const {
  return tracks_[nodes_[node].track].stations[nodes_[node].station];
}

std::vector<std::size_t> Roads::near(Point p, double radius_m) const {
  std::vector<std::size_t> found;
  const double x = std::floor(p.x_m / reach_m_);
  const double y = std::floor(p.y_m / reach_m_);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const auto cell = cells_.find(cell_key(x + dx, y + dy));
      if (cell == cells_.end()) continue;
      for (const std::size_t node : cell->second)
        if (distance_m(station(node).pose.at, p) <= radius_m) found.push_back(node);
    }
  std::sort(found.begin(), found.end());
  return found;
}

/// Those of `nodes` that a turn from `from` probably reaches soonest.
std::vector<std::size_t> Roads::likely(const Pose& from, const std::vector<std::size_t>& nodes,
                                       std::size_t most) const {
  std::vector<std::pair<double, std::size_t>> ranked;
  ranked.reserve(nodes.size());
  for (const std::size_t node : nodes)
    ranked.emplace_back(guess_m(from, station(node).pose, 1 / terrain_.limits.curvature_per_m), node);
  return foremost(std::move(ranked), most);
}

/// The lowest ranked, but few of any one line: else the many swath ends crowd out the one headland pass
/// beside them.
std::vector<std::size_t> Roads::foremost(std::vector<std::pair<double, std::size_t>> ranked,
                                         std::size_t most) const {
  std::sort(ranked.begin(), ranked.end());
  std::unordered_map<std::size_t, int> of_track;
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < ranked.size() && best.size() < most; ++i)
    if (++of_track[nodes_[ranked[i].second].track] <= kOfOneLine) best.push_back(ranked[i].second);
  return best;
}

std::optional<Roads::Link> Roads::along(std::size_t node) const {
  const Track& track = tracks_[nodes_[node].track];
  const std::size_t here = nodes_[node].station;
  const bool last = here + 1 == track.stations.size();
  if (last && !track.closed) return std::nullopt;
  const std::size_t next = last ? node - here : node + 1;
  if (next == node) return std::nullopt;
  Path path = part_of(track.path, track.stations[here].s_m, station(next).s_m);
  const double cost = cost_m(terrain_, path);
  return Link{next, std::move(path), cost};
}

const std::vector<Roads::Link>& Roads::links(std::size_t node) {
  const auto known = links_.find(node);
  if (known != links_.end()) return known->second;
  std::vector<Link> found;
  if (auto next = along(node)) found.push_back(std::move(*next));
  const Pose& pose = station(node).pose;
  std::vector<std::size_t> others = near(pose.at, reach_m_);
  std::erase_if(others, [&](std::size_t other) { return nodes_[other].track == nodes_[node].track; });
  for (const std::size_t other : likely(pose, others, kLinksTried)) {
    auto turn = direct_turn(terrain_, pose, station(other).pose);
    if (!turn) continue;
    const double cost = cost_m(terrain_, *turn);
    found.push_back({other, std::move(*turn), cost});
  }
  return links_.emplace(node, std::move(found)).first->second;
}

void Roads::keep_cheaper(Joins& joins, std::size_t node, Path path) const {
  const double cost = cost_m(terrain_, path);
  Join& known = joins.try_emplace(node, Join{{}, kFar}).first->second;
  if (cost < known.cost_m) known = {std::move(path), cost};
}

void Roads::join_from(Joins& joins, const Pose& pose, const Path& before) const {
  for (const std::size_t node : likely(pose, near(pose.at, reach_m_), kJoinsTried)) {
    auto turn = direct_turn(terrain_, pose, station(node).pose);
    if (turn) keep_cheaper(joins, node, joined(before, *turn, {}));
  }
}

void Roads::join_to(Joins& joins, const Pose& pose, const Path& after) const {
  // seen from behind: a turn driven towards the pose is as long as one from the pose turned about
  const Pose about{pose.at, pose.heading_rad + std::acos(-1.0)};
  std::vector<std::pair<double, std::size_t>> ranked;
  for (const std::size_t node : near(pose.at, reach_m_)) {
    const Pose& at = station(node).pose;
    ranked.emplace_back(
        guess_m(about, {at.at, at.heading_rad + std::acos(-1.0)}, 1 / terrain_.limits.curvature_per_m), node);
  }
  for (const std::size_t node : foremost(std::move(ranked), kJoinsTried)) {
    auto turn = direct_turn(terrain_, station(node).pose, pose);
    if (turn) keep_cheaper(joins, node, joined({}, *turn, after));
  }
}

Roads::Joins Roads::starts_from(const Pose& from, const std::vector<Path>& retreats) const {
  Joins starts;
  join_from(starts, from, {});
  for (const Path& run : retreats) join_from(starts, end_pose(run), run);
  return starts;
}

Roads::Joins Roads::ends_at(const Pose& to) const {
  Joins ends;
  join_to(ends, to, {});
  double ahead_m = 1 / terrain_.limits.curvature_per_m;
  while (terrain_.may_reverse && ahead_m < kFarthestBeyond_m) {
    const Pose beyond{to.at + ahead_m * unit(to.heading_rad), to.heading_rad};
    const Path run{{line(beyond.at, to.at), Gear::reverse}};
    if (!fits(terrain_.space, terrain_.footprint, run)) break;
    join_to(ends, beyond, run);
    ahead_m *= 2;
  }
  return ends;
}

std::optional<Path> Roads::way(const Pose& from, const Pose& to, const std::vector<Path>& retreats) {
  const Joins starts = starts_from(from, retreats);
  if (starts.empty()) return std::nullopt;
  const Joins ends = ends_at(to);
  if (ends.empty()) return std::nullopt;
  return between(starts, ends, to.at);
}

/// A* with the distance as the crow flies.
std::optional<Path> Roads::between(const Joins& starts, const Joins& ends, Point goal) {
  const auto rest_m = [&](std::size_t node) { return distance_m(station(node).pose.at, goal); };
  Frontier frontier;
  for (const auto& [node, join] : starts)
    frontier.reach(node, {join.cost_m, std::nullopt, &join.path}, rest_m(node));
  double least = kFar;
  std::optional<std::size_t> best;
  for (std::size_t visited = 0; !frontier.empty() && visited < kMostVisited; ++visited) {
    const auto [bound, node] = frontier.take();
    if (bound >= least) break;
    const double cost = frontier.cost_m(node);
    if (cost + rest_m(node) < bound - 1e-9) continue;  // was reached more cheaply since
    if (const auto end = ends.find(node); end != ends.end() && cost + end->second.cost_m < least) {
      least = cost + end->second.cost_m;
      best = node;
    }
    for (const Link& link : links(node))
      frontier.reach(link.to, {cost + link.cost_m, node, &link.path}, rest_m(link.to));
  }
  if (!best) return std::nullopt;
  return frontier.way_over(*best, ends.at(*best).path);
}

}  // namespace selion
