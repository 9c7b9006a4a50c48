// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "connect.hpp"
#include "known_ground.hpp"

namespace selion {

/// A turn to a node of the road network, worked out only when a search wants to drive it.
struct Link {
  std::size_t to = 0;
  Pose start;
  Pose end;
  const Path* after = nullptr;  ///< driven after the turn; outlives the link
  double turn_m = 0;            ///< the turn is no shorter
  double least_m = 0;           ///< it costs no less
  bool without_stops = false;   ///< none is found so
  bool worked_out = false;
  bool is_first_found = false;                              ///< another turn may take less time
  Path path;                                                ///< empty where there is none
  double cost_m = std::numeric_limits<double>::infinity();  ///< of both
};

/// A link of the least cost that a turn between the poses can have.
Link link_between(const Terrain& terrain, std::size_t to, const Pose& start, const Pose& end);
/// The first turn found for a link: of the many that a search asks for it drives few. First one without
/// stops; where there is none and the link is known to have none, one with stops.
void look_for_turn(const Terrain& terrain, const Link& link, KnownTurn& known);
/// Sets a link's path and cost by its turn; or what one with stops costs at least, still to be looked for.
void work_out(const Terrain& terrain, Link& link, const KnownTurn& known);
/// The link's path, its turn the one that takes least.
Path at_its_fastest(const Terrain& terrain, const Link& link);

/// What a lazy A* has reached so far and may drive next, the most promising first (edges worked out when they
/// come up: Cohen, Phillips and Likhachev 2014). The links must outlive it.
class Frontier {
 public:
  struct Entry {
    double bound_m = 0;  ///< the way by it to the goal costs no less
    std::size_t serial = 0;
    std::size_t node = 0;  ///< reached, or where `link` starts
    Link* link = nullptr;  ///< to be tried; none: the node is to be left by all its links

    friend bool operator>(const Entry& a, const Entry& b) {
      return std::tie(a.bound_m, a.serial) > std::tie(b.bound_m, b.serial);
    }
  };

  static constexpr std::size_t kStart = std::numeric_limits<std::size_t>::max();

  /// `rest_m`: the least that the way on from the link's end can cost.
  void propose(std::size_t from, Link& link, double rest_m);
  /// Drives the link where it leads to its end more cheaply than known.
  void drive(std::size_t from, const Link& link, double rest_m);

  [[nodiscard]] bool empty() const { return open_.empty(); }
  Entry take();
  /// May the proposed link still lead to its end more cheaply than known?
  [[nodiscard]] bool promises(const Entry& entry) const;
  /// Has the node been reached more cheaply since?
  [[nodiscard]] bool outdated(const Entry& entry, double rest_m) const;
  /// The links by which it is reached, from the start on.
  [[nodiscard]] std::vector<const Link*> way_to(std::size_t node) const;
  /// Of the nodes from `first` on, the one reached most cheaply, if any.
  [[nodiscard]] std::optional<std::size_t> cheapest_from(std::size_t first) const;
  /// Of the way by which it is reached; infinite where it is not.
  [[nodiscard]] double cost_m(std::size_t node) const;
  /// All nodes reached, in order.
  [[nodiscard]] std::vector<std::size_t> reached() const;

 private:
  struct Reached {
    double cost_m = std::numeric_limits<double>::infinity();
    std::size_t parent = kStart;
    const Link* by = nullptr;
  };

  std::size_t serial_ = 0;
  std::unordered_map<std::size_t, Reached> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace selion
