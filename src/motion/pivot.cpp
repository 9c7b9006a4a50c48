// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "families.hpp"
#include "offer.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr double kNoWay_m = 1e-9;
constexpr double kNoPivot_rad = 1e-11;  // a rotation by less is rounding
constexpr double kParallel = 1e-6;      // sine of the angle between lines that do not cross

double snapped(double angle_rad) { return std::abs(angle_rad) < kNoPivot_rad ? 0 : angle_rad; }

/// Towards the goal, straight to it, into its heading.
Pivots by_way_of_none(const Pose& goal) {
  const double line_m = length_m(goal.at);
  if (line_m < kNoWay_m) return {snapped(goal.heading_rad), 0, 0};
  const double towards = heading_rad(goal.at);
  return {snapped(towards), line_m, snapped(wrapped(goal.heading_rad - towards))};
}

/// Straight on to where the goal's line crosses, if that lies ahead and before the goal; one rotation there.
void add_corner(std::vector<Word>& words, const Pose& goal) {
  const Point along = unit(goal.heading_rad);
  if (std::abs(along.y_m) < kParallel) return;
  const double after_m = goal.at.y_m / along.y_m;
  const double before_m = goal.at.x_m - after_m * along.x_m;
  if (before_m <= kNoWay_m || after_m <= kNoWay_m) return;
  words.push_back({.before_m = before_m, .pivots = Pivots{goal.heading_rad, after_m, 0}});
}

}  // namespace

void pivot_words(std::vector<Word>& words, const Pose& goal, const Swings& /*swings*/) {
  words.push_back({.pivots = by_way_of_none(goal)});
  add_corner(words, goal);
  const auto turn = u_turn(goal);
  if (turn && turn->before_m + std::abs(turn->after_m) > kNoWay_m)
    words.push_back(
        {.before_m = turn->before_m, .after_m = turn->after_m, .pivots = by_way_of_none(turn->goal)});
}

}  // namespace selion
