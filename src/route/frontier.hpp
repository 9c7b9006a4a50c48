// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "selion/motion/path.hpp"

namespace selion {

/// What A* has reached so far, the most promising first. The paths reached by must outlive it.
class Frontier {
 public:
  struct Reached {
    double cost_m = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> parent;
    const Path* path = nullptr;  ///< from the parent
  };
  using Entry = std::pair<double, std::size_t>;  ///< lower bound of the cost to the goal, node

  /// Notes the node where no cheaper way to it is known; `rest_m` is the least that its way on can cost.
  void reach(std::size_t node, const Reached& by, double rest_m);
  [[nodiscard]] bool empty() const { return open_.empty(); }
  /// The entry of the lowest bound; a node comes up again for each time that it was reached.
  Entry take();
  [[nodiscard]] double cost_m(std::size_t node) const { return reached_.at(node).cost_m; }
  /// All paths up to the node, then `last`.
  [[nodiscard]] Path way_over(std::size_t node, const Path& last) const;

 private:
  std::unordered_map<std::size_t, Reached> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace selion
