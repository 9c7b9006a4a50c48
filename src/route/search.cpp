// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_map>
#include <unordered_set>

#include "connect.hpp"
#include "guide.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/dubins.hpp"

namespace selion {
namespace {

// Hybrid A* (Dolgov, Thrun, Montemerlo and Diebel 2010) whose moves begin and end with curvature 0, so that
// every path it finds is curvature-continuous, and whose heuristic is the way for a point over a grid,
// mainland dearer.

constexpr double kPi = std::numbers::pi;
constexpr double kGreed = 1.6;  // weight of the heuristic: within this factor of the best of its moves
constexpr std::size_t kMostLeft = 250;  // places: of ways found on real fields few needed 200
constexpr std::size_t kMostDepartures = 32;
constexpr int kMostRounds = 4;
constexpr std::size_t kMostShots = 3;      // goals tried from one place
constexpr std::size_t kMostReplaced = 60;  // stretches put into one turn
constexpr double kFar = std::numeric_limits<double>::infinity();

/// The path moved from the origin, heading east, to `pose`.
Path moved_to(const Pose& pose, Path path) {
  for (Stretch& stretch : path) {
    stretch.curve.start = placed(pose, stretch.curve.start);
    stretch.curve.heading_rad += pose.heading_rad;
  }
  return path;
}

/// Poses of one key are taken for the same place: cells of ground, shares of a whole turn.
std::uint64_t key_of(const Pose& pose, Gear gear, double cell_m, int headings) {
  const auto x =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(std::llround(pose.at.x_m / cell_m)) + (1 << 26));
  const auto y =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(std::llround(pose.at.y_m / cell_m)) + (1 << 26));
  const auto h = static_cast<std::uint64_t>(
      (std::llround(wrapped(pose.heading_rad) / (2 * kPi) * headings) + headings) % headings);
  return (x << 36) | (y << 8) | (h << 1) | (gear == Gear::reverse ? 1U : 0U);
}
std::uint64_t key_of(const Pose& pose, Gear gear) { return key_of(pose, gear, 0.6, 32); }
/// From near such a place a goal was tried in vain.
std::uint64_t shot_key_of(const Pose& pose) { return key_of(pose, Gear::forward, 1.5, 12); }

struct Node {
  Pose pose;
  Gear gear = Gear::forward;
  double cost = 0;
  std::size_t parent = 0;
  Path way;  // from the parent
  bool done = false;
};

class Search {
 public:
  Search(const Terrain& terrain, const std::vector<Pose>& from, const std::vector<Pose>& goals, Guide guide,
         KnownGround& known)
      : terrain_{terrain},
        goals_{goals},
        guide_{std::move(guide)},
        known_{known},
        departures_{from.size()},
        tried_(goals.size()) {
    const double step = std::max(1.0, 0.6 / terrain.limits.curvature_per_m);
    add_moves(Gear::forward, step);
    if (terrain.may_reverse) add_moves(Gear::reverse, step);
    for (const Pose& departure : from)
      nodes_.push_back({departure, Gear::forward, 0, nodes_.size(), {}, false});
    for (const std::size_t node : foremost_departures()) push(node);
  }

  std::optional<Found> run();
  /// Of each goal: has a turn into it been tried?
  [[nodiscard]] const std::vector<bool>& tried() const { return tried_; }

 private:
  struct Move {
    Path path;  // from the origin, heading east
    double length_m = 0;
    double turn_rad = 0;
    Point end;
    Gear gear;
  };
  void add_moves(Gear gear, double step_m);
  void push(std::size_t node);
  [[nodiscard]] std::optional<Path> moved(const Pose& pose, std::size_t move, TriedMoves& tried) const;
  void expand(std::size_t node);
  [[nodiscard]] std::vector<std::size_t> foremost_departures() const;
  [[nodiscard]] std::vector<std::size_t> nearest_goals(Point p) const;
  [[nodiscard]] std::optional<Arrival> shot(std::size_t node);
  [[nodiscard]] Found traced(std::size_t node, Arrival last) const;

  const Terrain& terrain_;
  const std::vector<Pose>& goals_;
  Guide guide_;
  KnownGround& known_;
  std::size_t departures_;  // the first nodes
  std::vector<bool> tried_;
  std::vector<Move> moves_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::size_t> best_;
  std::unordered_set<std::uint64_t> shots_;
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

void Search::add_moves(Gear gear, double step_m) {
  const auto add = [&](Path path) {
    for (Stretch& stretch : path) stretch.gear = Gear::forward;
    if (gear == Gear::reverse) path = backed(path);
    if (gear == Gear::reverse) {  // so that it starts at the origin: driven backwards from the move's end
      const Pose at = start_pose(path);
      for (Stretch& stretch : path) {
        const Point d = stretch.curve.start - at.at;
        const Point x = unit(-at.heading_rad);
        stretch.curve.start = d.x_m * x + d.y_m * left_of(x);
        stretch.curve.heading_rad -= at.heading_rad;
      }
    }
    const Pose end = end_pose(path);
    moves_.push_back({path, length_m(path), end.heading_rad, end.at, gear});
  };
  add({{line({0, 0}, {step_m, 0}), Gear::forward}});
  for (const double turn : {kPi / 16, -kPi / 16, kPi / 8, -kPi / 8, kPi / 4, -kPi / 4})
    add(swing({}, turn, terrain_.limits));
}

void Search::push(std::size_t node) {
  const double rest = guide_.to_goal_m(nodes_[node].pose.at);
  if (rest < kFar) open_.emplace(nodes_[node].cost + kGreed * rest, node);
}

/// The way of a move; absent where it does not stay inside.
std::optional<Path> Search::moved(const Pose& pose, std::size_t move, TriedMoves& tried) const {
  const std::uint32_t bit = std::uint32_t{1} << move;
  if ((tried.tried & bit) != 0 && (tried.inside & bit) == 0) return std::nullopt;
  Path way = moved_to(pose, moves_[move].path);
  if ((tried.tried & bit) != 0) return way;
  tried.tried |= bit;
  if (!stays_inside(terrain_.space, terrain_.footprint, way)) return std::nullopt;
  tried.inside |= bit;
  return way;
}

void Search::expand(std::size_t node) {
  const Pose pose = nodes_[node].pose;
  TriedMoves& tried = known_.moves[pose];
  for (std::size_t m = 0; m < moves_.size(); ++m) {
    const Move& move = moves_[m];
    const Pose end{placed(pose, move.end), pose.heading_rad + move.turn_rad};
    double cost = nodes_[node].cost + move.length_m;
    if (node >= departures_ && move.gear != nodes_[node].gear)
      cost += stop_m(terrain_.machine, terrain_.machine.turn_speed_mps);
    const std::uint64_t key = key_of(end, move.gear);
    const auto known = best_.find(key);
    if (known != best_.end() && nodes_[known->second].cost <= cost) continue;
    auto way = moved(pose, m, tried);
    if (!way) continue;
    if (terrain_.mainland.holds(end.at)) cost += kOverMainland * move.length_m;
    nodes_.push_back({end, move.gear, cost, node, std::move(*way), false});
    best_[key] = nodes_.size() - 1;
    push(nodes_.size() - 1);
  }
}

/// Those nearest to a goal: from further off the roads have led nowhere else.
std::vector<std::size_t> Search::foremost_departures() const {
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < departures_; ++i) ranked.emplace_back(guide_.to_goal_m(nodes_[i].pose.at), i);
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::size_t> foremost;
  for (std::size_t i = 0; i < ranked.size() && i < kMostDepartures; ++i) foremost.push_back(ranked[i].second);
  return foremost;
}

std::vector<std::size_t> Search::nearest_goals(Point p) const {
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < goals_.size(); ++i) ranked.emplace_back(distance_m(p, goals_[i].at), i);
  const std::size_t most = std::min(kMostShots, ranked.size());
  std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(most), ranked.end());
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < most; ++i) nearest.push_back(ranked[i].second);
  return nearest;
}

/// One turn from there into one of the nearest goals.
std::optional<Arrival> Search::shot(std::size_t node) {
  const Pose& here = nodes_[node].pose;
  const double longest = 12 / terrain_.limits.curvature_per_m + 2 * guide_.to_goal_m(here.at);
  for (const std::size_t goal : nearest_goals(here.at)) {
    tried_[goal] = true;
    if (dubins_length_m(here, goals_[goal], 1 / terrain_.limits.curvature_per_m) > longest) continue;
    Connections turns{here, goals_[goal], terrain_.swings};
    while (auto turn = turns.next(longest)) {
      if (stays_inside(terrain_.space, terrain_.footprint, *turn)) return Arrival{goal, std::move(*turn)};
    }
  }
  return std::nullopt;
}

Found Search::traced(std::size_t node, Arrival last) const {
  std::vector<const Path*> ways;
  std::size_t n = node;
  for (; n >= departures_; n = nodes_[n].parent) ways.push_back(&nodes_[n].way);
  std::reverse(ways.begin(), ways.end());
  Path whole;
  for (const Path* way : ways) append(whole, *way);
  append(whole, last.way);
  return {n, {last.goal, std::move(whole)}};
}

std::optional<Found> Search::run() {
  std::size_t left = 0;
  while (!open_.empty() && left < kMostLeft) {
    const std::size_t node = open_.top().second;
    open_.pop();
    if (nodes_[node].done) continue;
    nodes_[node].done = true;
    const bool near = guide_.to_goal_m(nodes_[node].pose.at) < 10 / terrain_.limits.curvature_per_m;
    if ((near || left % 8 == 0) && shots_.insert(shot_key_of(nodes_[node].pose)).second)
      if (auto last = shot(node)) return traced(node, std::move(*last));
    expand(node);
    ++left;
  }
  return std::nullopt;
}

/// Puts a single turn in place of the longest run of stretches from `first` on where it costs less and fits.
void shorten_from(Path& path, std::size_t first, const Terrain& terrain) {
  if (path[first].gear != Gear::forward || path[first].curve.curvature_per_m != 0) return;
  std::size_t same = first;
  while (same + 1 < path.size() && path[same + 1].gear == Gear::forward) ++same;
  for (std::size_t last = std::min(same, first + kMostReplaced); last > first + 1; --last) {
    if (std::abs(end_of(path[last].curve).curvature_per_m) > 1e-9) continue;
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = path.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    const Path old(begin, end);
    const auto turn = direct_turn(terrain, terrain.swings, start_pose(old), end_pose(old),
                                  length_m(old) * (1 + kOverMainland));
    if (!turn || cost_m(terrain, *turn) >= cost_m(terrain, old) - 0.01) continue;
    path.insert(path.erase(begin, end), turn->begin(), turn->end());
    return;
  }
}

Path shortened(const Terrain& terrain, Path path) {
  for (std::size_t i = 0; i < path.size(); ++i) shorten_from(path, i, terrain);
  return path;
}

/// Searches once; takes the goals that it came to in vain out of `goals`.
std::optional<Found> searched_once(const Terrain& terrain, const std::vector<Pose>& from,
                                   std::vector<Pose>& goals, KnownGround& known) {
  for (const double margin_m : {40.0, std::numeric_limits<double>::infinity()}) {
    Guide guide{terrain, from.front(), goals, margin_m};
    if (guide.to_goal_m(from.front().at) == kFar) continue;  // the way leads round about: look wider
    Search search{terrain, from, goals, std::move(guide), known};
    auto found = search.run();
    if (found) return found;
    std::vector<Pose> untried;
    for (std::size_t g = 0; g < goals.size(); ++g)
      if (!search.tried()[g]) untried.push_back(goals[g]);
    if (untried.size() == goals.size()) untried.clear();
    goals = std::move(untried);
    return std::nullopt;
  }
  goals.clear();
  return std::nullopt;
}

}  // namespace

/// Round by round: goals near at hand that cannot be driven into draw a search away from the others.
std::optional<Found> searched(const Terrain& terrain, const std::vector<Pose>& from,
                              const std::vector<Pose>& goals, KnownGround& known) {
  std::vector<Pose> left = goals;
  for (int round = 0; round < kMostRounds && !left.empty(); ++round) {
    auto found = searched_once(terrain, from, left, known);
    if (!found) continue;
    Path& way = found->arrival.way;
    way = shortened(terrain, shortened(terrain, std::move(way)));
    found->arrival.goal = static_cast<std::size_t>(
        std::find(goals.begin(), goals.end(), left[found->arrival.goal]) - goals.begin());
    return found;
  }
  return std::nullopt;
}

}  // namespace selion
