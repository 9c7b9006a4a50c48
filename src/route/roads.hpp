// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "connect.hpp"
#include "frontier.hpp"

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
  using Links = std::vector<Link>;
  using Stations = std::vector<std::size_t>;  ///< in order

  Roads(const Terrain& terrain, std::vector<Track> tracks, KnownGround& known);

  /// Cheapest way to one of the goals, found by A* over the stations; both ends are joined by single turns,
  /// the first after one of the `retreats` (ways backwards out of `from`) where that helps, the last before a
  /// straight run backwards into the goal where the machine may reverse. Where the network leads to no goal,
  /// a search of the ground from all that it leads to. Absent where that finds none either.
  std::optional<Arrival> way(const Pose& from, const std::vector<Pose>& goals,
                             const std::vector<Path>& retreats);

  [[nodiscard]] const Terrain& terrain() const { return terrain_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] const Pose& pose(std::size_t node) const { return nodes_[node].pose; }
  [[nodiscard]] bool is_junction(std::size_t node) const;
  /// As far as turns from or to one place are looked for.
  [[nodiscard]] double reach_m() const { return reach_m_; }

  /// Stations that a turn from the pose probably reaches soonest.
  [[nodiscard]] std::vector<std::size_t> likely_after(const Pose& from) const;
  /// Stations from which a turn probably reaches the pose soonest.
  [[nodiscard]] std::vector<std::size_t> likely_before(const Pose& to) const;
  /// To the next station of the node's own line, known at once; none where the line ends.
  Links& next_on_line(std::size_t node);
  /// To stations of other lines.
  Links& turns_from(std::size_t node);

  /// A link of a search's own, from where it begins or to its goals: worked out once for all searches.
  void work_out(Link& link);
  /// As far as turns without stops; where there is none, it may be worked on once more.
  void work_on(Link& link);
  /// What searches of the ground know already.
  KnownGround& known_ground() { return known_; }

  /// Remembers all the stations that a search reached, and that no road leads out of.
  const Stations* remember_realm(Stations stations);
  /// Such a set that holds all of these; none known: null.
  [[nodiscard]] const Stations* realm_of(const Stations& stations) const;

  /// Has the ground been searched in vain for a way to the goal, from all stations that are `reached` now?
  [[nodiscard]] bool searched_in_vain(const Pose& goal, const Stations& reached) const;
  void remember_in_vain(const std::vector<Pose>& goals, const Stations& reached);

  /// Is a long way worth a second search? Where two in a row were in vain, only each eighth is.
  bool is_care_due();
  void remember_care(bool has_found);

 private:
  struct Node {
    Pose pose;
    std::size_t track = 0;
    std::size_t station = 0;
  };
  using Ranked = std::vector<std::pair<double, std::size_t>>;

  [[nodiscard]] Ranked near(Point p, std::size_t but_track) const;
  template <class Guess>
  [[nodiscard]] std::vector<std::size_t> likely(Point at, std::size_t but_track, Guess guess) const;
  [[nodiscard]] std::vector<std::size_t> likely_after(const Pose& from, std::size_t but_track) const;
  [[nodiscard]] std::vector<std::size_t> foremost(const Ranked& ranked) const;

  const Terrain& terrain_;
  std::vector<Track> tracks_;
  std::vector<Node> nodes_;
  double reach_m_;
  std::unordered_map<long long, std::vector<std::size_t>> cells_;
  std::unordered_map<std::size_t, Links> turns_;
  std::unordered_map<std::size_t, Links> next_;
  KnownGround& known_;
  std::deque<Stations> realms_;
  unsigned cares_in_vain_ = 0;
  unsigned cares_left_out_ = 0;
  std::deque<Stations> searched_from_;
  std::unordered_map<Pose, std::vector<const Stations*>, PoseHash> in_vain_;  // to a goal
};

}  // namespace selion
