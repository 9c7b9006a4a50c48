// SPDX-License-Identifier: GPL-3.0-or-later
#include "roads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quest.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr std::size_t kTurnsTried = 10;  // from or to one place
constexpr int kOfOneLine = 2;
constexpr double kApart = 2;          // radii between those
constexpr double kOnePlace_m = 1e-6;  // nearer together, a chord has no bearing
constexpr std::size_t kNoTrack = std::numeric_limits<std::size_t>::max();

long long cell_key(double x, double y) {
  return (static_cast<long long>(x) << 32) ^ (static_cast<long long>(y) & 0xffffffffLL);
}

/// Roughly what a turn from `from` to `to` takes: the chord, and an arc for each change of heading on the
/// way.
double guess_m(const Pose& from, const Pose& to, double radius_m) {
  const Point chord = to.at - from.at;
  const double far_m = length_m(chord);
  const double bearing = far_m > kOnePlace_m ? heading_rad(chord) : from.heading_rad;
  return far_m + radius_m * (std::abs(wrapped(bearing - from.heading_rad)) +
                             std::abs(wrapped(to.heading_rad - bearing)));
}

}  // namespace

Roads::Roads(const Terrain& terrain, std::vector<Track> tracks, KnownGround& known)
    : terrain_{terrain},
      tracks_{std::move(tracks)},
      reach_m_{5 / terrain.limits.curvature_per_m + 3 * terrain.footprint.half_tool_m},
      known_{known} {
  for (std::size_t t = 0; t < tracks_.size(); ++t)
    for (std::size_t s = 0; s < tracks_[t].stations.size(); ++s) {
      const Pose& pose = tracks_[t].stations[s].pose;
      cells_[cell_key(std::floor(pose.at.x_m / reach_m_), std::floor(pose.at.y_m / reach_m_))].push_back(
          nodes_.size());
      nodes_.push_back({pose, t, s});
    }
}

bool Roads::is_junction(std::size_t node) const {
  return tracks_[nodes_[node].track].stations[nodes_[node].station].is_junction;
}

/// Within reach_m of p and not on `but_track`, with their distances, the nearest first.
Roads::Ranked Roads::near(Point p, std::size_t but_track) const {
  Ranked found;
  const double x = std::floor(p.x_m / reach_m_);
  const double y = std::floor(p.y_m / reach_m_);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const auto cell = cells_.find(cell_key(x + dx, y + dy));
      if (cell == cells_.end()) continue;
      for (const std::size_t node : cell->second) {
        const double far_m = distance_m(pose(node).at, p);
        if (far_m <= reach_m_ && nodes_[node].track != but_track) found.emplace_back(far_m, node);
      }
    }
  std::sort(found.begin(), found.end());
  return found;
}

/// Those near `at` of which guess(node) is least, but few of any one line: else the many swath ends crowd out
/// the one headland pass beside them. No guess is below the distance.
template <class Guess>
std::vector<std::size_t> Roads::likely(Point at, std::size_t but_track, Guess guess) const {
  constexpr std::size_t kAtOnce = 32;
  const Ranked by_distance = near(at, but_track);
  Ranked ranked;
  ranked.reserve(by_distance.size());
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < by_distance.size();) {
    for (const std::size_t end = std::min(i + kAtOnce, by_distance.size()); i < end; ++i)
      ranked.emplace_back(guess(pose(by_distance[i].second)), by_distance[i].second);
    std::sort(ranked.begin(), ranked.end());
    best = foremost(ranked);
    if (best.size() < kTurnsTried) continue;
    const auto last = std::find_if(ranked.begin(), ranked.end(),
                                   [&](const auto& entry) { return entry.second == best.back(); });
    if (by_distance[i - 1].first > last->first) break;  // so are all others
  }
  return best;
}

/// Two of one line lie some way apart: where the one is too close for a turn, the other need not be.
std::vector<std::size_t> Roads::foremost(const Ranked& ranked) const {
  std::vector<std::size_t> best;
  best.reserve(kTurnsTried);
  const double apart_m = kApart / terrain_.limits.curvature_per_m;
  for (std::size_t i = 0; i < ranked.size() && best.size() < kTurnsTried; ++i) {
    const std::size_t node = ranked[i].second;
    int of_its_line = 0;
    bool is_close = false;
    for (const std::size_t other : best) {
      if (nodes_[other].track != nodes_[node].track) continue;
      ++of_its_line;
      is_close |= distance_m(pose(other).at, pose(node).at) < apart_m;
    }
    if (of_its_line < kOfOneLine && !is_close) best.push_back(node);
  }
  return best;
}

std::vector<std::size_t> Roads::likely_after(const Pose& from, std::size_t but_track) const {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  return likely(from.at, but_track, [&](const Pose& to) { return guess_m(from, to, radius_m); });
}

std::vector<std::size_t> Roads::likely_after(const Pose& from) const { return likely_after(from, kNoTrack); }

std::vector<std::size_t> Roads::likely_before(const Pose& to) const {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  return likely(to.at, kNoTrack, [&](const Pose& from) { return guess_m(from, to, radius_m); });
}

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

Roads::Links& Roads::turns_from(std::size_t node) {
  const auto [known, is_new] = turns_.try_emplace(node);
  if (is_new)
    for (const std::size_t other : likely_after(pose(node), nodes_[node].track))
      known->second.push_back(link_between(terrain_, other, pose(node), pose(other)));
  return known->second;
}

void Roads::work_on(Link& link) {
  if (link.worked_out) return;
  const auto [known, is_new] = known_.turns.try_emplace({link.start, link.end});
  if (is_new || (link.without_stops && !known->second.is_all)) look_for_turn(terrain_, link, known->second);
  selion::work_out(terrain_, link, known->second);
}

void Roads::work_out(Link& link) {
  while (!link.worked_out) work_on(link);
}

const Roads::Stations* Roads::remember_realm(Stations stations) {
  return &realms_.emplace_back(std::move(stations));
}

const Roads::Stations* Roads::realm_of(const Stations& stations) const {
  const auto holds = [&stations](const Stations& realm) {
    return std::includes(realm.begin(), realm.end(), stations.begin(), stations.end());
  };
  const auto known = std::find_if(realms_.begin(), realms_.end(), holds);
  return known == realms_.end() || stations.empty() ? nullptr : &*known;
}

bool Roads::searched_in_vain(const Pose& goal, const Stations& reached) const {
  const auto known = in_vain_.find(goal);
  if (known == in_vain_.end() || reached.empty()) return false;
  return std::any_of(known->second.begin(), known->second.end(), [&](const Stations* from) {
    return std::includes(from->begin(), from->end(), reached.begin(), reached.end());
  });
}

void Roads::remember_in_vain(const std::vector<Pose>& goals, const Stations& reached) {
  const Stations* from = &searched_from_.emplace_back(reached);
  for (const Pose& goal : goals) in_vain_[goal].push_back(from);
}

bool Roads::is_care_due() {
  constexpr unsigned kInVain = 2;
  constexpr unsigned kEachTime = 8;
  return cares_in_vain_ < kInVain || ++cares_left_out_ % kEachTime == 0;
}

void Roads::remember_care(bool has_found) { cares_in_vain_ = has_found ? 0 : cares_in_vain_ + 1; }

std::optional<Arrival> Roads::way(const Pose& from, const std::vector<Pose>& goals,
                                  const std::vector<Path>& retreats) {
  return Quest{*this, from, goals, retreats}.way();
}

}  // namespace selion
