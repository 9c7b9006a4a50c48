// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.hpp"

#include "retreats.hpp"

namespace selion {
namespace {

constexpr std::size_t kRoadWays = 4;  // ways into a piece of work that the roads are asked for
constexpr std::size_t kSearchedWays = 2;
constexpr double kFarRound = 3;  // a way this many turns long is worth a search for a shorter one

}  // namespace

Driver::Driver(const Block& block, const Layout& layout, const Machine& machine)
    : machine_{machine},
      space_{free_space(block.free, footprint_of(machine))},
      mainland_{layout.mainland},
      terrain_{space_, footprint_of(machine), limits_at(machine, machine.turn_speed_mps), machine.may_reverse,
               mainland_},
      roads_{terrain_, tracks_of(layout, machine, terrain_)} {}

/// Beyond this a way is a transfer.
double Driver::longest_turn_m() const {
  return 14 / terrain_.limits.curvature_per_m + 6 * terrain_.footprint.half_tool_m;
}

/// The pose `run_in_m` before the work begins: from there the tool is brought down on a straight line.
Pose Driver::before(const Path& work) const {
  const Pose start = start_pose(work);
  return {start.at - machine_.run_in_m * unit(start.heading_rad), start.heading_rad};
}

std::vector<Path> Driver::ways_back() const {
  return machine_.may_reverse ? retreats(driven_) : std::vector<Path>{};
}

void Driver::work(const Task& task, const Path& way, const Path& work) {
  const PieceKind kind = length_m(way) <= longest_turn_m() ? PieceKind::turn : PieceKind::transfer;
  if (!way.empty()) driven_.push_back({kind, "", way});
  driven_.push_back({task.kind, task.id, work});
  here_ = end_pose(work);
}

void Driver::consider(std::optional<Approach>& best, const Path& work, std::optional<Path> way) const {
  if (!way) return;
  const double cost = cost_m(terrain_, *way);
  if (!best || cost < best->cost_m - 1e-6) best = Approach{&work, std::move(*way), cost};
}

/// The cheapest of the task's ways: by one turn each; where that is a long one, by the roads; where these
/// lead far round or nowhere, by searching.
std::optional<Driver::Approach> Driver::approach(const Task& task) {
  std::optional<Approach> best;
  const auto each = [&](std::size_t most, const auto& way_to) {
    for (std::size_t i = 0; i < task.ways.size() && i < most; ++i)
      consider(best, task.ways[i], way_to(before(task.ways[i])));
  };
  each(task.ways.size(), [this](const Pose& goal) { return direct_turn(terrain_, *here_, goal); });
  if (!best || best->cost_m > longest_turn_m()) {
    const std::vector<Path> back = ways_back();
    each(kRoadWays, [&](const Pose& goal) { return roads_.way(*here_, goal, back); });
  }
  const bool close = far_m(here_, before(task.ways.front())) < longest_turn_m();
  if (!best || (close && best->cost_m > kFarRound * longest_turn_m()))
    each(kSearchedWays, [this](const Pose& goal) { return searched(terrain_, *here_, goal); });
  return best;
}

bool Driver::drive_to(const Task& task) {
  if (task.ways.empty()) return false;
  if (!here_) {
    work(task, {}, task.ways.front());
    return true;
  }
  std::optional<Approach> best = approach(task);
  if (!best) return false;
  if (machine_.run_in_m > 0)
    best->way.push_back({line(before(*best->work).at, start_pose(*best->work).at), Gear::forward});
  work(task, best->way, *best->work);
  return true;
}

bool Driver::drive_out_to(const Pose& goal) {
  auto way = connect(terrain_, roads_, *here_, goal);
  if (!way) way = roads_.way(*here_, goal, ways_back());
  if (!way) return false;
  driven_.push_back({PieceKind::transfer, "", std::move(*way)});
  here_ = goal;
  return true;
}

}  // namespace selion
