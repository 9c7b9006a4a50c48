// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "retreats.hpp"

namespace selion {
namespace {

/// Without stretches that are nothing but rounding.
Path without_crumbs(Path path) {
  constexpr double kCrumb_m = 5e-7;  // half of what joints may miss
  std::erase_if(
      path, [](const Stretch& stretch) { return stretch.curve.length_m < kCrumb_m && !is_pivot(stretch); });
  return path;
}

}  // namespace

Driver::Driver(const Block& block, const Layout& layout, const Machine& machine, KnownGround& known)
    : layout_{layout},
      machine_{machine},
      known_{known},
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
  if (!roads_) roads_.emplace(terrain_, tracks_of(layout_, machine_, terrain_), known_);
  return *roads_;
}

/// Beyond this a way is a transfer.
double Driver::longest_turn_m() const {
  return 14 / terrain_.limits.curvature_per_m + 6 * terrain_.footprint.half_tool_m;
}

/// The pose `run_in_m` before the work begins: from there the tool is brought down on a straight line. Nearer
/// where the machine does not fit so far back.
Pose Driver::before(const Pose& start, double run_in_m) const {
  constexpr std::array kShares{1.0, 0.75, 0.5, 0.25};
  if (run_in_m <= 0) return start;
  for (const double share : kShares) {
    const Point begin = start.at - share * run_in_m * unit(start.heading_rad);
    if (stays_inside(space_, terrain_.footprint, {{line(begin, start.at), Gear::forward}}))
      return {begin, start.heading_rad};
  }
  return start;
}

/// Where no way leads to a run-in, the tool is brought down where the work begins.
std::vector<double> Driver::run_ins_m() const {
  return machine_.run_in_m > 0 ? std::vector{machine_.run_in_m, 0.0} : std::vector{0.0};
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

std::vector<Driver::Goal> Driver::goals_of(const Task& task, double run_in_m) const {
  std::vector<Goal> goals;
  for (const Way& way : task.ways) goals.push_back({before(way.start, run_in_m), way.rest_m});
  return goals;
}

void Driver::drive_by(const Task& task, const std::vector<Goal>& goals, Approach approach) {
  const Pose goal = goals[approach.goal].pose;
  approach = or_ahead(std::move(approach), goal);
  const Way& chosen = task.ways[approach.goal];
  const Point begin = goals[approach.goal].pose.at;
  if (begin != chosen.start.at) approach.way.push_back({line(begin, chosen.start.at), Gear::forward});
  work(task, approach.way, path_of(task, chosen));
}

bool Driver::turn_to(const Task& task) {
  if (!here_ || task.ways.empty()) return false;
  for (const double run_in_m : run_ins_m()) {
    const std::vector<Goal> goals = goals_of(task, run_in_m);
    auto turn = turn_into(goals, terrain_.swings, longest_turn_m(), goals.size());
    if (!turn || turn->cost_m > longest_turn_m()) continue;
    drive_by(task, goals, std::move(*turn));
    return true;
  }
  return false;
}

bool Driver::drive_to(const Task& task) {
  if (task.ways.empty()) return false;
  if (here_) return drive_to_one_of({task}).has_value();
  work(task, {}, path_of(task, task.ways.front()));
  return true;
}

std::optional<std::size_t> Driver::drive_to_one_of(const std::vector<Task>& tasks) {
  if (!here_) return std::nullopt;
  for (const double run_in_m : run_ins_m()) {
    std::vector<Goal> goals;
    std::vector<std::size_t> first_goal;
    first_goal.reserve(tasks.size());
    for (const Task& task : tasks) {
      first_goal.push_back(goals.size());
      const std::vector<Goal> its = goals_of(task, run_in_m);
      goals.insert(goals.end(), its.begin(), its.end());
    }
    if (goals.empty()) return std::nullopt;
    std::optional<Approach> best = approach(goals);
    if (!best) continue;
    const auto beyond = std::upper_bound(first_goal.begin(), first_goal.end(), best->goal);
    const auto task = static_cast<std::size_t>(beyond - first_goal.begin()) - 1;
    best->goal -= first_goal[task];
    goals.erase(goals.begin(), goals.begin() + static_cast<std::ptrdiff_t>(first_goal[task]));
    drive_by(tasks[task], goals, std::move(*best));
    return task;
  }
  return std::nullopt;
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
