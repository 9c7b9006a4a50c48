// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.hpp"

#include "retreats.hpp"
#include "selion/motion/dubins.hpp"

namespace selion {
namespace {

constexpr double kNoBetter_m = 1e-6;
constexpr double kFarRound = 3;  // a way this many turns long is worth a search for a shorter one

/// Without stretches that are nothing but rounding.
Path without_crumbs(Path path) {
  constexpr double kCrumb_m = 5e-7;  // half of what joints may miss
  std::erase_if(path, [](const Stretch& stretch) { return stretch.curve.length_m < kCrumb_m; });
  return path;
}

}  // namespace

Driver::Driver(const Block& block, const Layout& layout, const Machine& machine)
    : machine_{machine},
      space_{free_space(block.free, footprint_of(machine))},
      mainland_{layout.mainland},
      terrain_{space_,
               footprint_of(machine),
               limits_at(machine, machine.turn_speed_mps),
               Swings{limits_at(machine, machine.turn_speed_mps)},
               machine.may_reverse,
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
  if (Path clean = without_crumbs(way); !clean.empty()) driven_.push_back({kind, "", std::move(clean)});
  driven_.push_back({task.kind, task.id, without_crumbs(work)});
  here_ = end_pose(work);
}

/// The cheapest single turn.
std::optional<Driver::Approach> Driver::turn_into(const std::vector<Pose>& goals) const {
  std::optional<Approach> best;
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (best && dubins_length_m(*here_, goals[i], radius_m) >= best->cost_m) continue;
    auto turn = direct_turn(terrain_, *here_, goals[i]);
    if (!turn) continue;
    const double cost = cost_m(terrain_, *turn);
    if (!best || cost < best->cost_m - kNoBetter_m) best = Approach{i, std::move(*turn), cost};
  }
  return best;
}

std::optional<Driver::Approach> Driver::by(std::optional<Arrival> arrival) const {
  if (!arrival) return std::nullopt;
  const double cost = cost_m(terrain_, arrival->way);
  return Approach{arrival->goal, std::move(arrival->way), cost};
}

/// The cheapest of: one turn; where that is a long one, the roads; where these lead far round or nowhere, a
/// search.
std::optional<Driver::Approach> Driver::approach(const std::vector<Pose>& goals) {
  std::optional<Approach> best = turn_into(goals);
  const auto keep_cheaper = [&best](std::optional<Approach> other) {
    if (other && (!best || other->cost_m < best->cost_m - kNoBetter_m)) best = std::move(other);
  };
  if (!best || best->cost_m > longest_turn_m()) keep_cheaper(by(roads_.way(*here_, goals, ways_back())));
  const bool close = far_m(here_, goals.front()) < longest_turn_m();
  if (best && close && best->cost_m > kFarRound * longest_turn_m())
    if (auto found = searched(terrain_, {*here_}, goals)) keep_cheaper(by(std::move(found->arrival)));
  return best;
}

bool Driver::drive_to(const Task& task) {
  if (task.ways.empty()) return false;
  if (!here_) {
    work(task, {}, task.ways.front());
    return true;
  }
  std::vector<Pose> goals;
  for (const Path& way : task.ways) goals.push_back(before(way));
  std::optional<Approach> best = approach(goals);
  if (!best) return false;
  const Path& chosen = task.ways[best->goal];
  if (machine_.run_in_m > 0)
    best->way.push_back({line(goals[best->goal].at, start_pose(chosen).at), Gear::forward});
  work(task, best->way, chosen);
  return true;
}

bool Driver::drive_out_to(const Pose& goal) {
  std::optional<Approach> best = approach({goal});
  if (!best) return false;
  if (Path clean = without_crumbs(std::move(best->way)); !clean.empty())
    driven_.push_back({PieceKind::transfer, "", std::move(clean)});
  here_ = goal;
  return true;
}

}  // namespace selion
