// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <numbers>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "connect.hpp"

namespace selion {

/// Shortest ways for a point to the nearest goal over square cells, mainland dearer: the heuristic of the
/// search.
class Guide {
 public:
  static constexpr double kMostCells = 500;  // a side

  /// Over the field within `margin_m` of the box around all poses, by so many `cells` a side; more where
  /// these would be wider than the tool, for then none may fit on the headland.
  Guide(const Terrain& terrain, const Pose& from, const std::vector<Pose>& goals, double margin_m,
        double cells = kMostCells);

  /// Infinite where no way was found.
  [[nodiscard]] double to_goal_m(Point p) const;

 private:
  enum class Ground : unsigned char { unknown, closed, open, mainland };
  struct Step {
    int dx;
    int dy;
    double cells;  ///< its length
  };

  [[nodiscard]] std::optional<std::size_t> cell_of(Point p) const;
  [[nodiscard]] Point centre_of(std::size_t cell) const;
  template <class Visit>
  void for_neighbours(std::size_t cell, Visit visit) const;
  [[nodiscard]] bool open(const Terrain& terrain, Point p) const;
  [[nodiscard]] Ground ground_at(const Terrain& terrain, Point p) const;
  [[nodiscard]] static double dearness(Ground ground);
  using Entry = std::pair<double, std::size_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;
  static constexpr double kAcross = std::numbers::sqrt2;
  static constexpr auto kSteps = std::to_array<Step>({{-1, -1, kAcross},
                                                      {0, -1, 1},
                                                      {1, -1, kAcross},
                                                      {-1, 0, 1},
                                                      {1, 0, 1},
                                                      {-1, 1, kAcross},
                                                      {0, 1, 1},
                                                      {1, 1, kAcross}});
  void reach(Queue& queue, std::size_t cell, double distance_m);
  void spread(const Terrain& terrain, const std::vector<Pose>& goals);

  Point low_;
  double cell_m_ = 1;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<double> distance_;
};

}  // namespace selion
