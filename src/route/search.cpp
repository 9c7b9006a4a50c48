// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_map>

#include "connect.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

// Hybrid A* (Dolgov, Thrun, Montemerlo and Diebel 2010) whose moves begin and end with curvature 0, so that
// every path it finds is curvature-continuous, and whose heuristic is the way for a point over a grid,
// mainland dearer.

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kMostNodes = 4000;
constexpr double kGreed = 1.6;  // weight of the heuristic: within this factor of the best of its moves
constexpr double kOverMainland = 0.5;
constexpr double kInReverse = 1.0;
constexpr double kGearChange_m = 6;
constexpr int kHeadings = 32;
constexpr double kMostCells = 500;  // a side of the heuristic's grid
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Shortest ways for a point to the goal over square cells.
class Guide {
 public:
  Guide(const Terrain& terrain, const Pose& from, const Pose& to, double margin_m);
  [[nodiscard]] double to_goal_m(Point p) const;

 private:
  [[nodiscard]] std::size_t cell_of(Point p) const;
  [[nodiscard]] Point centre_of(std::size_t cell) const;
  [[nodiscard]] bool open(const Terrain& terrain, Point p) const;
  void spread(const Terrain& terrain, Point goal);

  Point low_;
  double cell_m_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<double> distance_;
};

Guide::Guide(const Terrain& terrain, const Pose& from, const Pose& to, double margin_m) {
  const Box field = bounds(terrain.space.area().shell);
  const Box both = bounds({from.at, to.at});
  low_ = {std::max(field.low.x_m, both.low.x_m - margin_m), std::max(field.low.y_m, both.low.y_m - margin_m)};
  const Point high{std::min(field.high.x_m, both.high.x_m + margin_m),
                   std::min(field.high.y_m, both.high.y_m + margin_m)};
  const Point size = high - low_;
  cell_m_ = std::max(0.75, std::max(size.x_m, size.y_m) / kMostCells);
  columns_ = static_cast<std::size_t>(std::max(0.0, size.x_m) / cell_m_) + 1;
  rows_ = static_cast<std::size_t>(std::max(0.0, size.y_m) / cell_m_) + 1;
  distance_.assign(columns_ * rows_, kFar);
  spread(terrain, to.at);
}

std::size_t Guide::cell_of(Point p) const {
  const double x = std::floor((p.x_m - low_.x_m) / cell_m_);
  const double y = std::floor((p.y_m - low_.y_m) / cell_m_);
  if (x < 0 || y < 0 || x >= static_cast<double>(columns_) || y >= static_cast<double>(rows_))
    return distance_.size();
  return static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x);
}

Point Guide::centre_of(std::size_t cell) const {
  return low_ + Point{(static_cast<double>(cell % columns_) + 0.5) * cell_m_,
                      (static_cast<double>(cell / columns_) + 0.5) * cell_m_};
}

/// Half the body has room there; touching squares keep the walk inside without asking again.
bool Guide::open(const Terrain& terrain, Point p) const {
  if (terrain.space.far_from_border(p)) return true;
  const double half = std::max(cell_m_ / 2, 0.8 * terrain.footprint.half_body_m);
  return terrain.space.clear(
      {p + Point{-half, -half}, p + Point{half, -half}, p + Point{half, half}, p + Point{-half, half}});
}

void Guide::spread(const Terrain& terrain, Point goal) {
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const std::size_t start = cell_of(goal);
  if (start == distance_.size()) return;
  std::vector<signed char> state(distance_.size(),
                                 -1);  // unknown, closed to the machine, open, open mainland
  const auto look = [&](std::size_t cell) {
    if (state[cell] < 0) {
      const Point p = centre_of(cell);
      const bool main = std::any_of(terrain.mainland.begin(), terrain.mainland.end(),
                                    [p](const Polygon& m) { return contains(m, p); });
      state[cell] = static_cast<signed char>(!open(terrain, p) ? 0 : main ? 2 : 1);
    }
    return state[cell];
  };
  distance_[start] = 0;
  queue.emplace(0, start);
  while (!queue.empty()) {
    const auto [d, cell] = queue.top();
    queue.pop();
    if (d > distance_[cell]) continue;
    const auto x = static_cast<int>(cell % columns_);
    const auto y = static_cast<int>(cell / columns_);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || x + dx < 0 || y + dy < 0 || x + dx >= static_cast<int>(columns_) ||
            y + dy >= static_cast<int>(rows_))
          continue;
        const std::size_t other =
            static_cast<std::size_t>(y + dy) * columns_ + static_cast<std::size_t>(x + dx);
        const int what = look(other);
        if (what == 0) continue;
        const double step = cell_m_ * std::hypot(dx, dy) * (what == 2 ? 1 + kOverMainland : 1);
        if (d + step >= distance_[other]) continue;
        distance_[other] = d + step;
        queue.emplace(d + step, other);
      }
  }
}

double Guide::to_goal_m(Point p) const {
  const std::size_t cell = cell_of(p);
  if (cell == distance_.size()) return kFar;
  double best =
      distance_[cell];  // a pose may stand in a cell that is closed by the half body's square: look around it
  if (best < kFar) return best;
  for (const Point step : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}}) {
    const std::size_t other = cell_of(p + cell_m_ * step);
    if (other != distance_.size()) best = std::min(best, distance_[other] + cell_m_);
  }
  return best;
}

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
  Search(const Terrain& terrain, const Pose& from, const Pose& to, Guide guide)
      : terrain_{terrain}, to_{to}, guide_{std::move(guide)} {
    const double step = std::max(1.0, 0.6 / terrain.limits.curvature_per_m);
    add_moves(Gear::forward, step);
    if (terrain.may_reverse) add_moves(Gear::reverse, step);
    nodes_.push_back({from, Gear::forward, 0, 0, {}, false});
    push(0);
  }

  std::optional<Path> run();

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
  [[nodiscard]] std::uint64_t key_of(const Pose& pose, Gear gear) const;
  [[nodiscard]] Path placed_move(const Move& move, const Pose& pose) const;
  void expand(std::size_t node);
  [[nodiscard]] std::optional<Path> shot(std::size_t node) const;
  [[nodiscard]] Path traced(std::size_t node, Path last) const;

  const Terrain& terrain_;
  Pose to_;
  Guide guide_;
  std::vector<Move> moves_;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::size_t> best_;
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

Path Search::placed_move(const Move& move, const Pose& pose) const {
  Path path = move.path;
  for (Stretch& stretch : path) {
    stretch.curve.start = placed(pose, stretch.curve.start);
    stretch.curve.heading_rad += pose.heading_rad;
  }
  return path;
}

std::uint64_t Search::key_of(const Pose& pose, Gear gear) const {
  constexpr double kCell_m = 0.6;
  const auto x =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(std::llround(pose.at.x_m / kCell_m)) + (1 << 26));
  const auto y =
      static_cast<std::uint64_t>(static_cast<std::int64_t>(std::llround(pose.at.y_m / kCell_m)) + (1 << 26));
  const auto h = static_cast<std::uint64_t>(
      (std::llround(wrapped(pose.heading_rad) / (2 * kPi) * kHeadings) + kHeadings) % kHeadings);
  return (x << 36) | (y << 8) | (h << 1) | (gear == Gear::reverse ? 1U : 0U);
}

void Search::push(std::size_t node) {
  const double rest = guide_.to_goal_m(nodes_[node].pose.at);
  if (rest < kFar) open_.emplace(nodes_[node].cost + kGreed * rest, node);
}

void Search::expand(std::size_t node) {
  for (const Move& move : moves_) {
    const Pose pose = nodes_[node].pose;
    const Pose end{placed(pose, move.end), pose.heading_rad + move.turn_rad};
    double cost = nodes_[node].cost + move.length_m * (move.gear == Gear::reverse ? 1 + kInReverse : 1);
    if (node != 0 && move.gear != nodes_[node].gear) cost += kGearChange_m;
    const std::uint64_t key = key_of(end, move.gear);
    const auto known = best_.find(key);
    if (known != best_.end() && nodes_[known->second].cost <= cost) continue;
    Path way = placed_move(move, pose);
    if (!stays_inside(terrain_.space, terrain_.footprint, way)) continue;
    if (std::any_of(terrain_.mainland.begin(), terrain_.mainland.end(),
                    [&end](const Polygon& m) { return contains(m, end.at); }))
      cost += kOverMainland * move.length_m;
    nodes_.push_back({end, move.gear, cost, node, std::move(way), false});
    best_[key] = nodes_.size() - 1;
    push(nodes_.size() - 1);
  }
}

std::optional<Path> Search::shot(std::size_t node) const {
  const double rest = guide_.to_goal_m(nodes_[node].pose.at);
  const double longest = 12 / terrain_.limits.curvature_per_m + 2 * rest;
  for (Path& turn : connections(nodes_[node].pose, to_, terrain_.limits)) {
    if (length_m(turn) > longest) break;
    if (stays_inside(terrain_.space, terrain_.footprint, turn)) return std::move(turn);
  }
  return std::nullopt;
}

Path Search::traced(std::size_t node, Path last) const {
  std::vector<const Path*> ways;
  for (std::size_t n = node; n != 0; n = nodes_[n].parent) ways.push_back(&nodes_[n].way);
  Path whole;
  for (auto it = ways.rbegin(); it != ways.rend(); ++it) append(whole, **it);
  append(whole, last);
  return whole;
}

std::optional<Path> Search::run() {
  std::size_t expanded = 0;
  while (!open_.empty() && nodes_.size() < kMostNodes) {
    const std::size_t node = open_.top().second;
    open_.pop();
    if (nodes_[node].done) continue;
    nodes_[node].done = true;
    const bool near = guide_.to_goal_m(nodes_[node].pose.at) < 10 / terrain_.limits.curvature_per_m;
    if (near || expanded % 8 == 0)
      if (auto last = shot(node)) return traced(node, std::move(*last));
    expand(node);
    ++expanded;
  }
  return std::nullopt;
}

/// Replaces runs of stretches by single turns where these cost less and fit.
Path shortened(const Terrain& terrain, Path path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i].gear != Gear::forward || path[i].curve.curvature_per_m != 0) continue;
    std::size_t same = i;
    while (same + 1 < path.size() && path[same + 1].gear == Gear::forward) ++same;
    for (std::size_t j = std::min(same, i + 60); j > i + 1; --j) {
      if (std::abs(end_of(path[j].curve).curvature_per_m) > 1e-9) continue;
      const Path old(path.begin() + static_cast<std::ptrdiff_t>(i),
                     path.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      const auto turn = direct_turn(terrain, start_pose(old), end_pose(old));
      if (!turn || cost_m(terrain, *turn) >= cost_m(terrain, old) - 0.01) continue;
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(i),
                 path.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      path.insert(path.begin() + static_cast<std::ptrdiff_t>(i), turn->begin(), turn->end());
      break;
    }
  }
  return path;
}

}  // namespace

std::optional<Path> searched(const Terrain& terrain, const Pose& from, const Pose& to) {
  for (const double margin_m : {40.0, std::numeric_limits<double>::infinity()}) {
    Guide guide{terrain, from, to, margin_m};
    if (guide.to_goal_m(from.at) == kFar) continue;  // the way leads round about: look wider
    auto path = Search{terrain, from, to, std::move(guide)}.run();
    if (!path) return std::nullopt;
    return shortened(terrain, shortened(terrain, std::move(*path)));
  }
  return std::nullopt;
}

}  // namespace selion
