// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "offer.hpp"

namespace selion {
namespace {

constexpr double kLeastBack_m = 0.01;  // a shorter way back is not worth two changes of gear
constexpr auto kBack = std::to_array<double>({1, 0.5, 0});  // curvatures back, of the limit

/// Between the centres of the first and the last arc, by the arc back: its own centre lies on the other side
/// of the machine, (1 + 1/q) radii from both.
struct Back {
  double turn_rad = 0;
  double length_m = 0;
};
std::optional<Back> back_between(double apart_m, double back_per_m, double radius_m) {
  if (back_per_m == 0) return Back{0, apart_m};
  const double sine = apart_m / 2 / (radius_m + 1 / back_per_m);
  if (sine > 1) return std::nullopt;
  const double turn_rad = 2 * std::asin(sine);
  return Back{turn_rad, turn_rad / back_per_m};
}

/// To the left, to a goal seen from the start.
void add_left(std::vector<Word>& words, const UTurn& turn, const Swings& swings, int side) {
  const Pose goal = side > 0 ? turn.goal : mirrored(turn.goal);
  const Point centre = swings.centre();
  const Point last_centre = placed(goal, {-centre.x_m, centre.y_m});
  const Point back_way = centre - last_centre;
  const double limit = swings.limits().curvature_per_m;
  const double least_rad = swings.full_rad() / 2;  // half a swing that reaches the limit
  for (const double share : kBack) {
    const auto back = back_between(length_m(back_way), share * limit, 1 / limit);
    if (!back || back->length_m < kLeastBack_m) continue;
    const double first = whole_turns_off(heading_rad(back_way) - back->turn_rad / 2);
    const double last = whole_turns_off(goal.heading_rad - first - back->turn_rad);
    if (std::min(first, last) < least_rad || std::max(first, last) > std::numbers::pi) continue;
    words.push_back({.before_m = turn.before_m,
                     .after_m = turn.after_m,
                     .cusps = Cusps{first, share * limit, back->length_m, last, side}});
  }
}

}  // namespace

void cusp_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  const auto turn = u_turn(goal);
  for (const int side : {1, -1}) {
    add_left(words, {.goal = goal}, swings, side);
    if (turn && turn->before_m + turn->after_m > 0) add_left(words, *turn, swings, side);
  }
}

double length_m(const Cusps& cusps, const CurveLimits& limits) {
  // Half a swing is half a clothoid longer than an arc of its deflection.
  const double ramp_m = limits.curvature_per_m / limits.sharpness_per_m2;
  return (cusps.first_rad + cusps.last_rad) / limits.curvature_per_m + ramp_m + cusps.back_m;
}

void draw_cusps(Drawn& drawn, const Cusps& cusps, const Swings& swings) {
  const CurveLimits& limits = swings.limits();
  const double ramp_m = limits.curvature_per_m / limits.sharpness_per_m2;
  const double half_rad = swings.full_rad() / 2;
  const Point turn = cusps.side > 0 ? swings.full_half() : mirrored(swings.full_half());
  const Point ramp = cusps.side > 0 ? swings.full_ramp() : mirrored(swings.full_ramp());
  const double k = cusps.side * limits.curvature_per_m;
  const double g = cusps.side * limits.sharpness_per_m2;
  draw_ramp(drawn, {0, g, ramp_m, turned(turn, ramp), turn});
  draw_arc(drawn, k, (cusps.first_rad - half_rad) / limits.curvature_per_m);
  if (cusps.back_per_m > 0)
    draw_arc_back(drawn, cusps.side * cusps.back_per_m, cusps.back_m);
  else
    draw_line_back(drawn, cusps.back_m);
  draw_arc(drawn, k, (cusps.last_rad - half_rad) / limits.curvature_per_m);
  draw_ramp(drawn, {k, -g, ramp_m, mirrored(ramp), turn});
}

}  // namespace selion
