// SPDX-License-Identifier: GPL-3.0-or-later
#include "frontier.hpp"

#include <algorithm>

namespace selion {

void Frontier::reach(std::size_t node, const Reached& by, double rest_m) {
  Reached& known = reached_[node];
  if (by.cost_m >= known.cost_m) return;
  known = by;
  open_.emplace(by.cost_m + rest_m, node);
}

Frontier::Entry Frontier::take() {
  const Entry lowest = open_.top();
  open_.pop();
  return lowest;
}

Path Frontier::way_over(std::size_t node, const Path& last) const {
  std::vector<const Path*> parts{&last};
  for (std::optional<std::size_t> at = node; at; at = reached_.at(*at).parent)
    parts.push_back(reached_.at(*at).path);
  std::reverse(parts.begin(), parts.end());
  Path whole;
  for (const Path* part : parts) append(whole, *part);
  return whole;
}

}  // namespace selion
