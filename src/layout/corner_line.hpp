// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "parts.hpp"

namespace selion {

/// A closed line of corners being made drivable: corner_line.cpp gives each corner the room that it needs,
/// corner_repair.cpp moves what does not fit.
class CornerLine {
 public:
  CornerLine(const Ground& ground, const Ring& ring);

  /// Merges and drops corners until each has room on its edges. False where nothing is left to drive round.
  bool make_room();
  /// Lets corners that have the room be driven at working speed.
  void make_gentle();
  [[nodiscard]] Path path() const;
  /// Moves what does not fit; false when nothing could be moved.
  bool repair();
  [[nodiscard]] bool fits() const;
  /// The longest runs of edges and corners that fit, where the whole does not.
  [[nodiscard]] std::vector<HeadlandRun> fitting_runs() const;

 private:
  struct Vertex {
    Point at;
    bool pushed = false;  ///< swung out already: its neighbours on the edges stand
    double turn_rad = 0;
    double tangent_m = 0;
    CurveLimits limits;
  };

  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % vertices_.size(); }
  [[nodiscard]] std::size_t previous(std::size_t i) const {
    return (i + vertices_.size() - 1) % vertices_.size();
  }
  [[nodiscard]] Point edge(std::size_t i) const { return vertices_[next(i)].at - vertices_[i].at; }
  [[nodiscard]] double room_m(std::size_t i) const {
    return length_m(edge(i)) - vertices_[i].tangent_m - vertices_[next(i)].tangent_m;
  }
  void measure(std::size_t i);
  void measure_all();
  void drop(std::size_t i) { vertices_.erase(vertices_.begin() + static_cast<std::ptrdiff_t>(i)); }
  void relieve(std::size_t i);
  [[nodiscard]] std::optional<std::size_t> tightest_edge() const;
  bool merge(std::size_t i);
  [[nodiscard]] Path corner_path(std::size_t i) const;
  [[nodiscard]] Path edge_path(std::size_t i) const;
  void chamfer(std::size_t i, std::vector<Vertex>& into) const;
  void swing_out(std::size_t i, std::vector<Vertex>& into) const;

  const Ground& ground_;
  CurveLimits tight_;
  CurveLimits gentle_;
  std::vector<Vertex> vertices_;
};

}  // namespace selion
