// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "selion/core/point.hpp"
#include "swing.hpp"

namespace selion {

/// A turn whose curvature rises, dips to `dip_per_m` in its middle, rises again and ends at 0.
struct Dip {
  double dip_per_m = 0;
  double first_rad = 0;  ///< deflection up to the middle, as a magnitude
  double second_rad = 0;
  Point first{1, 0};  ///< unit(first_rad)
  Point second{1, 0};
  int side = 1;  ///< 1 for left
};

/// Three swings in turn to one side, to the other and to the first again; signed.
using ThreeSwings = std::array<double, 3>;

/// A rotation on the spot, a straight, another rotation.
struct Pivots {
  double first_rad = 0;
  double line_m = 0;
  double second_rad = 0;
};

/// A fishtail whose wheels are steered while it stands: half a swing, to the arc of the curvature limit;
/// back, on an arc that turns on to the same side or on a straight; half a swing from that arc on.
/// Magnitudes.
struct Cusps {
  double first_rad = 0;
  double back_per_m = 0;
  double back_m = 0;
  double last_rad = 0;
  int side = 1;  ///< 1 for left
};

/// A way not yet drawn: a straight, a swing, a straight, two swings or a dip, pivots or
/// cusps, a straight. What is 0 is
/// left out.
struct Word {
  double before_m = 0;
  std::array<Deflection, 3> swings{};
  double line_m = 0;  ///< after the first swing; below 0 in reverse
  std::optional<Dip> dip = std::nullopt;
  double after_m = 0;
  std::optional<Pivots> pivots = std::nullopt;  ///< before the last straight, as cusps are
  std::optional<Cusps> cusps = std::nullopt;
};

Word word_of(const ThreeSwings& swings_rad);
double length_m(const Word& word, const Swings& swings);
void draw_word(Drawn& drawn, const Word& word, const Swings& swings);

double length_m(const Dip& dip, const CurveLimits& limits);
void draw_dip(Drawn& drawn, const Dip& dip, const Swings& swings);

/// Swing, straight, swing: adds all that reach `goal`; a side is 1 for left, -1 for right.
void add_swing_line_swings(std::vector<Word>& words, const Pose& goal, int first_side, int second_side,
                           const Swings& swings);

double length_m(const Cusps& cusps, const CurveLimits& limits);
void draw_cusps(Drawn& drawn, const Cusps& cusps, const Swings& swings);

/// The same, also those whose straight leads back (line_m below 0): it is driven in reverse.
void add_swings_on_a_line(std::vector<Word>& words, const Pose& goal, int first_side, int second_side,
                          const Swings& swings);

/// Finds three swings to a goal: the miss over a grid of the first and third deflections, a start for
/// Newton's method wherever it may vanish on a triangle of the grid. The grid's diagonals, on which the first
/// and the third deflection add up to the same, are looked at one by one, shortest ways first.
class ThreeSwingSearch {
 public:
  static constexpr std::size_t kDiagonals = 2 * Swings::kParts;

  /// `side` 1: left, right, left; -1: right, left, right.
  ThreeSwingSearch(const Pose& goal, int side, const Swings& swings);

  struct Start {
    ThreeSwings near_rad;  ///< magnitudes
    double least_m = 0;    ///< no triple of its cell is shorter
  };
  /// Of the diagonals by rank, those of the least deflections first: no triple is shorter. Absent past the
  /// last.
  [[nodiscard]] std::optional<double> least_m(std::size_t rank) const;
  void add_starts(std::vector<Start>& starts, std::size_t rank) const;
  /// The triple that a start leads to; absent where there is none or it has been found before.
  std::optional<ThreeSwings> found(const Start& start);

 private:
  using Corners = std::array<Point, 3>;
  struct Triangle;
  void add_start(std::vector<Start>& starts, const Triangle& at, const Corners& corners) const;
  [[nodiscard]] Point miss(std::size_t first, std::size_t third, std::size_t second) const;

  const Swings* swings_;
  Pose goal_;  // mirrored where the first swing is one to the right
  int side_;
  double far_m_ = 0;  // a larger miss does not vanish within the cell
  std::size_t shift_ = 0;
  double third_least_rad_ = 0;
  std::array<Point, Swings::kParts + 2> third_start_;
  std::vector<ThreeSwings> known_;
};

/// Are three swings to a goal worth looking for? Farther off, a straight is shorter.
bool near_for_three(const Pose& goal, const Swings& swings);
/// All three swings to the goal that the search finds, the first one to `side`.
void add_three_swings(std::vector<Word>& words, const Pose& goal, int side, const Swings& swings);

/// `start` brought to the goal by Newton steps; empty if it does not get there.
std::optional<ThreeSwings> polished(const ThreeSwings& start, const Pose& goal, const Swings& swings);

}  // namespace selion
