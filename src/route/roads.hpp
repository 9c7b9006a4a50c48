// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "connect.hpp"
#include "frontier.hpp"
#include "guide.hpp"

namespace selion {

struct Layout;

/// A line that is driven anyway, as a one-way road: the axle's path and the straight places where one can
/// join or leave.
struct Track {
  Path path;
  bool closed = true;
  double length_m = 0;
  struct Station {
    double s_m = 0;
    Pose pose;
    bool is_junction = true;  ///< left by turns also by those who only pass
  };
  std::vector<Station> stations;  ///< in order of s
};

Track track_of(const Path& path, bool closed);
/// Of a straight line, joined and left within `end_m` of its ends only.
Track track_joined_at_ends(const Path& line, double end_m);
/// Every line of the layout, in each direction in which the machine fits on it.
std::vector<Track> tracks_of(const Layout& layout, const Machine& machine, const Terrain& terrain);
/// A straight way on from a pose, as far as the machine fits, 20 m at most; empty where it fits nowhere.
Path run_on(const Terrain& terrain, const Pose& from);
/// The part of a path from `from_m` to `to_m` along it; of a closed one across its seam where to < from or to
/// > its length.
Path part_of(const Path& path, double from_m, double to_m);

/// Headland passes, pocket pieces and swaths as a road network: stations, joined along their line and by
/// single turns from line to line. A turn is worked out when a search first wants to drive it, and kept.
class Roads {
 public:
  Roads(const Terrain& terrain, std::vector<Track> tracks);

  /// Cheapest way to one of the goals, found by A* over the stations; both ends are joined by single turns,
  /// the first after one of the `retreats` (ways backwards out of `from`) where that helps, the last before a
  /// straight run backwards into the goal where the machine may reverse. Where the network leads to no goal,
  /// a search of the ground from all that it leads to. Absent where that finds none either.
  std::optional<Arrival> way(const Pose& from, const std::vector<Pose>& goals,
                             const std::vector<Path>& retreats);

 private:
  struct Node {
    std::size_t track = 0;
    std::size_t station = 0;
  };
  using Links = std::vector<Link>;

  /// What one search looks for; its goals are nodes beyond those of the network.
  struct Quest {
    const Pose& from;
    const std::vector<Pose>& goals;
    Links starts;
    std::unordered_map<std::size_t, Links> ends;
    std::vector<std::vector<Path>> runs_back;  ///< into each goal
    std::unordered_map<std::size_t, double> rest_m;
    std::optional<Guide> guide;  ///< over a long way
  };

  [[nodiscard]] const Pose& pose(std::size_t node) const;
  [[nodiscard]] std::vector<std::size_t> near(Point p) const;
  template <class Guess>
  [[nodiscard]] std::vector<std::size_t> likely(Point at, std::size_t but_track, Guess guess) const;
  [[nodiscard]] std::vector<std::size_t> foremost(
      const std::vector<std::pair<double, std::size_t>>& ranked) const;
  [[nodiscard]] std::vector<std::size_t> likely_after(const Pose& from, std::size_t but_track) const;
  [[nodiscard]] std::vector<std::size_t> likely_before(const Pose& to) const;
  [[nodiscard]] bool leaves_by_turns(Quest& quest, std::size_t node) const;
  Links& turns_from(std::size_t node);
  Links& next_on_line(std::size_t node);
  void add_starts(Quest& quest, const Pose& from, const std::vector<Path>& retreats) const;
  void add_ends(Quest& quest, std::size_t goal) const;
  [[nodiscard]] std::vector<Path> runs_back_into(const Pose& to) const;
  [[nodiscard]] static double crow_m(const Pose& from, const std::vector<Pose>& goals);
  double rest_m(Quest& quest, std::size_t node) const;
  [[nodiscard]] std::optional<Arrival> beyond(const Pose& from, const Frontier& frontier,
                                              const std::vector<Pose>& goals,
                                              const std::vector<Path>& retreats) const;
  void expand(Frontier& frontier, const Frontier::Entry& next, Quest& quest);

  const Terrain& terrain_;
  std::vector<Track> tracks_;
  std::vector<Node> nodes_;
  double reach_m_;
  std::unordered_map<long long, std::vector<std::size_t>> cells_;
  std::unordered_map<std::size_t, Links> turns_;
  std::unordered_map<std::size_t, Links> next_;
};

}  // namespace selion
