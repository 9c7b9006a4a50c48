// SPDX-License-Identifier: GPL-3.0-or-later
// Where the roads of a quest lead to no goal: through the ground between them.
#include <algorithm>
#include <iterator>
#include <utility>

#include "quest.hpp"

namespace selion {

/// Where it sets out and all nodes reached, the ones nearest to a goal first.
std::vector<std::size_t> Quest::departures() const {
  std::vector<std::pair<double, std::size_t>> ranked{{crow_m(starts_.front().pose.at), roads_.size()}};
  for (const std::size_t node : frontier_.reached())
    if (node != roads_.size()) ranked.emplace_back(crow_m(pose(node).at), node);
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::size_t> nodes(ranked.size());
  std::transform(ranked.begin(), ranked.end(), nodes.begin(), [](const auto& entry) { return entry.second; });
  return nodes;
}

/// Those that may still be reached over the ground.
std::vector<Pose> Quest::goals_not_in_vain(const Roads::Stations& reached) const {
  std::vector<Pose> open;
  std::copy_if(goals_.begin(), goals_.end(), std::back_inserter(open),
               [&](const Pose& goal) { return !roads_.searched_in_vain(goal, reached); });
  return open;
}

/// Through the ground between the roads: from all places that they lead to.
std::optional<Arrival> Quest::beyond() {
  const Roads::Stations known = realm_ != nullptr ? *realm_ : stations_reached();
  const std::vector<Pose> goals = goals_not_in_vain(known);
  if (goals.empty()) return std::nullopt;
  const std::vector<std::size_t> nodes = departures();
  std::vector<Pose> poses(nodes.size());
  std::transform(nodes.begin(), nodes.end(), poses.begin(), [&](std::size_t node) { return pose(node); });
  auto found = searched(terrain_, poses, goals, roads_.known_ground());
  if (!found) {
    roads_.remember_in_vain(goals, known);
    return std::nullopt;
  }
  Path whole = way_to(nodes[found->departure]);
  append(whole, found->arrival.way);
  const auto goal = std::find(goals_.begin(), goals_.end(), goals[found->arrival.goal]);
  return Arrival{static_cast<std::size_t>(goal - goals_.begin()), std::move(whole)};
}

}  // namespace selion
