// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>
#include <optional>
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
    std::size_t offset;  ///< of the cell it leads to; wraps round
    double length_m;
  };

  [[nodiscard]] std::optional<std::size_t> cell_of(Point p) const;
  [[nodiscard]] Point centre_of(std::size_t cell) const;
  [[nodiscard]] bool open(const Terrain& terrain, Point p) const;
  [[nodiscard]] Ground ground_at(const Terrain& terrain, Point p) const;
  [[nodiscard]] static double dearness(Ground ground);
  struct Reached {
    double distance_m;
    std::size_t cell;
  };
  /// By whole lengths of a cell. No step is shorter: from one bucket all lead into later ones, so that their
  /// order does not matter (Dial 1969; Denardo and Fox 1979).
  using Buckets = std::vector<std::vector<Reached>>;
  /// What is known while distances are spread from the goals.
  struct Wave {
    const Terrain& terrain;
    std::array<Step, 8> around;
    std::vector<Ground> ground;
    Buckets buckets;
  };
  [[nodiscard]] std::array<Step, 8> steps() const;
  [[nodiscard]] std::vector<Ground> unknown_within_rim() const;
  void go_on_from(Reached done, Wave& wave);
  void reach(Buckets& buckets, std::size_t cell, double distance_m);
  void spread(const Terrain& terrain, const std::vector<Pose>& goals);

  Point low_;
  double cell_m_ = 1;
  std::size_t columns_ = 3;  ///< with a rim of closed cells
  std::size_t rows_ = 3;
  std::vector<double> distance_;
};

}  // namespace selion
