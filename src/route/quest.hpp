// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "frontier.hpp"
#include "guide.hpp"
#include "roads.hpp"

namespace selion {

/// One search for a way over the roads: weighted A* (Pohl 1970), edges worked out when they come up. Its
/// nodes are the stations, then the places to set out from, then the goals.
class Quest {
 public:
  Quest(Roads& roads, const Pose& from, const std::vector<Pose>& goals, const std::vector<Path>& retreats);

  std::optional<Arrival> way();

 private:
  static constexpr double kGreed = 2;  // of most searches

  /// Where it sets out: `from`, or the end of a retreat. The turns from there are looked for when it comes
  /// up.
  struct Start {
    Pose pose;
    Link retreat;
    std::optional<Roads::Links> turns;
  };
  /// Where a last turn may lead: a goal, or a place from which it is run into backwards.
  struct End {
    std::size_t goal = 0;
    Pose pose;
    Path run;
    double run_m = 0;  ///< what that costs
    bool joined = false;
    std::vector<std::pair<std::size_t, Link*>> turns;  ///< into it, from which station; once joined
  };
  /// A place that the way to a goal leads through, and what the rest costs from there.
  struct Entry {
    Pose pose;
    double rest_m = 0;
  };

  [[nodiscard]] bool has_few_goals() const { return goals_.size() <= 4; }
  [[nodiscard]] std::size_t first_goal() const { return roads_.size() + starts_.size(); }
  [[nodiscard]] const Pose& pose(std::size_t node) const;
  void add_start(const Pose& at, const Path& retreat);
  void guide_beyond(double reaches);
  void add_ends(std::size_t goal);
  bool find_entries();
  bool add_entries(std::size_t end);
  [[nodiscard]] double crow_m(Point at) const;
  [[nodiscard]] double dubins_m(const Pose& at) const;
  double rest_m(std::size_t node);
  double rest_after_m(const Link& link);
  [[nodiscard]] bool leaves_by_turns(std::size_t node) const;
  [[nodiscard]] Link link_into(const End& end, const Pose& from) const;
  Roads::Links& turns_of(Start& start);
  void join(std::size_t end);
  void join_near(Point at);
  void propose(std::size_t from, Link& link);
  void expand(const Frontier::Entry& next);
  void leave(std::size_t node);
  [[nodiscard]] Path way_to(std::size_t node) const;
  [[nodiscard]] Arrival arrival(std::size_t goal) const;
  std::optional<std::size_t> found(std::size_t most_visited);
  std::optional<std::size_t> found();
  std::optional<std::size_t> found_beside(Roads::Stations shut);
  [[nodiscard]] std::vector<std::size_t> departures() const;
  [[nodiscard]] Roads::Stations stations_reached() const;
  [[nodiscard]] std::vector<Pose> goals_not_in_vain(const Roads::Stations& reached) const;
  std::optional<Arrival> beyond();
  Arrival or_cheaper(std::size_t goal);

  Roads& roads_;
  const Terrain& terrain_;
  const std::vector<Pose>& goals_;
  std::deque<Start> starts_;
  std::deque<End> ends_;
  std::deque<Link> end_links_;
  std::vector<Entry> entries_;
  const Roads::Stations* realm_ = nullptr;  // all that can be reached from here, where that is known
  Roads::Stations shut_;                    // from none of them a goal is reached
  std::unordered_map<std::size_t, std::vector<Link*>> to_ends_;  // from a station
  std::unordered_map<std::size_t, double> rest_m_;
  std::optional<Guide> guide_;  // over a long way
  double greed_ = kGreed;       // weight of the distance to go
  Frontier frontier_;
};

}  // namespace selion
