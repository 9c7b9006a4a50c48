// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "corner_shape.hpp"
#include "parts.hpp"

namespace selion {

/// A closed line of corners being made drivable: corner_line.cpp gives each corner the room that it needs,
/// corner_repair.cpp moves what does not fit.
class CornerLine {
 public:
  /// `room_m`: beyond the lane's outer edge, for body and tool to swing out into.
  CornerLine(const Ground& ground, const Ring& line, double room_m);

  /// Merges and drops corners until each has room on its edges. False where nothing is left to drive round.
  bool make_room();
  /// Lets corners that have the room be driven at working speed.
  void make_gentle();
  [[nodiscard]] Path path() const;
  /// Moves what does not fit; false when nothing was moved.
  bool repair();
  [[nodiscard]] bool fits() const;
  /// The longest runs of edges and corners that fit, where the whole does not.
  [[nodiscard]] std::vector<HeadlandRun> fitting_runs() const;

 private:
  using Index = std::size_t;
  static constexpr double kLeastEdge_m = 0.02;
  static constexpr double kSharpest_rad = 2.6;  ///< a corner of the line turning more than this is cut off
  struct Vertex {
    Point at;
    Index previous = 0;
    Index next = 0;
    double room_m = 0;
    bool dropped = false;
    bool cut = false;        ///< comes of a corner cut off; where it is one corner again, that was in vain
    bool pushed = false;     ///< swung out already: its neighbours on the edges stand
    bool may_gentle = true;  ///< until it has been found not to fit
    bool gentle = false;
    bool corner_stays = false;  ///< is known to stay inside
    bool edge_stays = false;    ///< the same of the edge after it
    double turn_rad = 0;
    CornerShape shape;
    double shaped_for_rad = 0;  ///< the turn and the room that the shape was made for
    double shaped_in_m = -1;
    CornerReach reach;
  };
  /// An edge shorter than its corners need.
  struct Tight {
    double room_m = 0;
    Index edge = 0;

    friend bool operator>(const Tight& a, const Tight& b) {
      return std::tie(a.room_m, a.edge) > std::tie(b.room_m, b.edge);
    }
  };

  [[nodiscard]] Index next(Index i) const { return vertices_[i].next; }
  [[nodiscard]] Index previous(Index i) const { return vertices_[i].previous; }
  [[nodiscard]] Point edge(Index i) const { return vertices_[next(i)].at - vertices_[i].at; }
  [[nodiscard]] double room_m(Index i) const;
  [[nodiscard]] CornerShape tight_shape(double turn_rad, double room_m) const;
  void make_shape(Vertex& v) const;
  void measure(Index i);
  void measure_around(Index i);
  void measure_all();
  void drop(Index i);
  void replace(Index i, const std::vector<Vertex>& by);
  void relieve(Index i);
  void blunt(Index i);
  bool merge(Index i);
  bool slide(Index i, Index corner);
  bool spread(Index i);
  [[nodiscard]] Path corner_at(Index i) const;
  [[nodiscard]] Path edge_path(Index i) const;
  [[nodiscard]] bool stays(const Path& path) const;
  bool check_corner(Index i);
  bool check_edge(Index i);
  bool ease(Index i);
  bool swing_wide(Index i);
  [[nodiscard]] std::vector<Vertex> wide(Index i, double by_rad) const;
  [[nodiscard]] bool fits_wide(Index i, const std::vector<Vertex>& wide) const;
  [[nodiscard]] double chamfer_wish_m(Index i) const;
  void chamfer(Index i);
  void swing_out(Index i);

  const Ground& ground_;
  CurveLimits tight_;
  CurveLimits gentle_;
  std::vector<Vertex> vertices_;
  Index first_ = 0;
  std::size_t count_ = 0;
  std::priority_queue<Tight, std::vector<Tight>, std::greater<>> tight_edges_;
};

}  // namespace selion
