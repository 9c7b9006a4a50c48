// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ways of a quest end: its goals, and how they are come to.
#include <algorithm>
#include <cmath>
#include <limits>

#include "quest.hpp"
#include "selion/motion/dubins.hpp"

namespace selion {
namespace {

constexpr double kFarthestBeyond_m = 150;  // of a straight run backwards into a pose
constexpr std::size_t kMostRunInto = 64;   // goals: of more, some can be driven into forwards

}  // namespace

void Quest::add_ends(std::size_t goal) {
  const Pose& to = goals_[goal];
  ends_.push_back({goal, to, {}, 0, false, {}});
  if (!terrain_.may_reverse || goals_.size() > kMostRunInto) return;
  const double step_m = 2 / terrain_.limits.curvature_per_m;
  for (int k = 1; k * step_m < kFarthestBeyond_m; ++k) {
    const Point begin = to.at + k * step_m * unit(to.heading_rad);
    const Point last = begin - step_m * unit(to.heading_rad);
    if (!fits(terrain_.space, terrain_.footprint, {{line(begin, last), Gear::reverse}})) break;
    Path run{{line(begin, to.at), Gear::reverse}};
    const double run_m = cost_m(terrain_, run);
    ends_.push_back({goal, start_pose(run), std::move(run), run_m, false, {}});
  }
}

double Quest::crow_m(Point at) const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Pose& goal : goals_) least_m = std::min(least_m, distance_m(at, goal.at));
  return least_m;
}

void Quest::join(std::size_t end) {
  ends_[end].joined = true;
  for (const std::size_t node : roads_.likely_before(ends_[end].pose)) {
    Link* kept = &end_links_.emplace_back(link_into(ends_[end], roads_.pose(node)));
    ends_[end].turns.emplace_back(node, kept);
    to_ends_[node].push_back(kept);
  }
}

/// The ends that stations here may be joined to: all within reach.
void Quest::join_near(Point at) {
  for (std::size_t i = 0; i < ends_.size(); ++i)
    if (!ends_[i].joined && distance_m(at, ends_[i].pose.at) <= roads_.reach_m()) join(i);
}

/// Works out the turns into the goals, to know where one has to get to. False where there are none from
/// stations that may be reached.
bool Quest::find_entries() {
  entries_.clear();
  std::optional<std::size_t> open_goal;
  for (std::size_t e = 0; e < ends_.size(); ++e) {
    if (open_goal == ends_[e].goal)
      entries_.push_back({ends_[e].pose, ends_[e].run_m});
    else if (add_entries(e))
      open_goal = ends_[e].goal;
  }
  if (open_goal) return true;
  for (const End& end : ends_) entries_.push_back({end.pose, end.run_m});
  return false;
}

/// The turns found into an end, from stations that may be reached.
bool Quest::add_entries(std::size_t end) {
  const std::size_t before = entries_.size();
  if (!ends_[end].joined) join(end);
  for (const auto& [station, link] : ends_[end].turns) {
    if (realm_ != nullptr && !std::binary_search(realm_->begin(), realm_->end(), station)) continue;
    roads_.work_out(*link);
    if (!std::isinf(link->cost_m)) entries_.push_back({link->start, link->cost_m});
  }
  return entries_.size() > before;
}

/// By the entry that takes least, on the shortest way of bounded curvature.
double Quest::dubins_m(const Pose& at) const {
  const double radius_m = 1 / terrain_.limits.curvature_per_m;
  double least_m = std::numeric_limits<double>::infinity();
  for (const Entry& entry : entries_)
    if (distance_m(at.at, entry.pose.at) + entry.rest_m < least_m)
      least_m = std::min(least_m, dubins_length_m(at, entry.pose, radius_m) + entry.rest_m);
  return least_m;
}

}  // namespace selion
