// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "families.hpp"
#include "offer.hpp"
#include "root.hpp"

namespace selion {
namespace {

constexpr double kNoCurve_m = 1e-12;
constexpr double kMet_m = 1e-9;
constexpr double kSettled = 1e-4;

/// Half of a dip: clothoid up to the peak, arc, clothoid down to the dip.
struct Half {
  double peak_per_m = 0;
  double up_m = 0;
  double arc_m = 0;
  double down_m = 0;
};

/// Deflection of a half without an arc at the curvature limit.
double arcless_rad(double dip_per_m, const CurveLimits& limits) {
  const double k = limits.curvature_per_m;
  return (2 * k * k - dip_per_m * dip_per_m) / (2 * limits.sharpness_per_m2);
}

/// Empty where so small a deflection does not reach the curvature of the dip.
std::optional<Half> half_of(double dip_per_m, double deflection_rad, const CurveLimits& limits) {
  const double g = limits.sharpness_per_m2;
  const double bent_rad = deflection_rad - arcless_rad(dip_per_m, limits);
  if (bent_rad >= 0)
    return Half{limits.curvature_per_m, limits.curvature_per_m / g, bent_rad / limits.curvature_per_m,
                (limits.curvature_per_m - dip_per_m) / g};
  const double square = g * deflection_rad + dip_per_m * dip_per_m / 2;
  if (!(square >= 0)) return std::nullopt;
  const double peak = std::min(std::sqrt(square), limits.curvature_per_m);
  if (peak < dip_per_m * (1 - 1e-12) || dip_per_m < 0) return std::nullopt;
  return Half{peak, peak / g, 0, std::max(peak - dip_per_m, 0.0) / g};
}

/// A clothoid from straight on to `curvature_per_m`: where it leads, in the frame of its end, and its turn.
struct Rise {
  Point way;
  Point turn;
};
Rise rise_to(double curvature_per_m, const Swings& swings) {
  const CurveLimits& limits = swings.limits();
  if (curvature_per_m == limits.curvature_per_m) return {swings.full_ramp(), swings.full_half()};
  const double turned_rad = curvature_per_m * curvature_per_m / (2 * limits.sharpness_per_m2);
  return {Swings::ramp(turned_rad, curvature_per_m / limits.sharpness_per_m2), unit(turned_rad)};
}

/// The clothoid between the curvature of the dip and that of the peak, upwards, in the frame of the dip: the
/// rise to the peak less the rise to the dip.
Rise between(const Rise& dip, const Rise& peak) {
  const Point turn = turned(mirrored(dip.turn), peak.turn);
  return {turned(turn, peak.way) - dip.way, turn};
}

/// Where half a dip leads from the origin, heading east.
Point way_of(const Half& half, double dip_per_m, double deflection_rad, const Swings& swings) {
  const Rise peak = rise_to(half.peak_per_m, swings);
  Point way = turned(peak.turn, peak.way);
  if (half.arc_m > 0) {
    const Point half_arc = unit(half.peak_per_m * half.arc_m / 2);
    way = way + (2 * half_arc.y_m / half.peak_per_m) * turned(peak.turn, half_arc);
  }
  return way + turned(unit(deflection_rad), mirrored(between(rise_to(dip_per_m, swings), peak).way));
}

/// Where the whole dip leads: its second half is the mirror image of a first one.
std::optional<Point> way_of(const Dip& dip, const Swings& swings) {
  const auto first = half_of(dip.dip_per_m, dip.first_rad, swings.limits());
  const auto second = half_of(dip.dip_per_m, dip.second_rad, swings.limits());
  if (!first || !second) return std::nullopt;
  const Point back = way_of(*second, dip.dip_per_m, dip.second_rad, swings);
  return way_of(*first, dip.dip_per_m, dip.first_rad, swings) +
         turned(unit(dip.first_rad + dip.second_rad), mirrored(back));
}

/// The dip whose arcs' centres are `apart_m` from each other, 0 < apart_m < 2 a. Half of that, x, is seen
/// from the dip; dx/dq = (q y - 1) / g and dy/dq = -q x / g. So x falls with the dip's curvature q nearly as
/// p^2, p = K - q: x = p^2 / (2 g K) (1 - (K p / g)^2 / 12 + 7 K p^3 / (60 g^2) - ...), and Halley's steps
/// in its square root finish.
double dip_of(double apart_m, const Swings& swings) {
  const double k = swings.limits().curvature_per_m;
  const double g = swings.limits().sharpness_per_m2;
  const double goal = std::sqrt(apart_m / 2);
  const double per_g = 1 / g;
  const double below = std::sqrt(g * k * apart_m);
  const double bend = k * below * per_g;
  const double skew = 7 * bend * below * below * per_g;
  double dip = std::max(k - below * (1 + bend * bend / 24 - skew / 120), 0.0);
  for (int i = 0; i < 12; ++i) {
    const Rise rise = rise_to(dip, swings);
    const Point centre = turned(mirrored(rise.turn), swings.centre()) - rise.way;
    if (!(centre.x_m > 0)) break;
    const double root = std::sqrt(centre.x_m);
    const double fall = (dip * centre.y_m - 1) * per_g;                        // dx/dq
    const double bow = (centre.y_m - dip * dip * centre.x_m * per_g) * per_g;  // its own
    const double off = 2 * root * (root - goal);
    const double step = off / (fall - off * (bow / fall - fall / (2 * centre.x_m)) / 2);
    dip = std::clamp(dip - step, 0.0, k);
    if (std::abs(step) < kSettled * k) break;  // the next one is its cube
  }
  return dip;
}

/// Both halves with an arc at the curvature limit: the two arcs' centres fix the middle's heading, and their
/// distance the dip.
std::optional<Dip> dip_between_arcs(const Pose& goal, double deflection_rad, const Swings& swings) {
  const Point centre = swings.centre();
  const Point ahead = unit(deflection_rad);
  const Point between = goal.at - turned(ahead, mirrored(centre)) - centre;
  const double apart = std::sqrt(dot(between, between));
  if (apart == 0 || apart >= 2 * centre.x_m) return std::nullopt;
  const double first = whole_turns_off(heading_rad(between));
  const double least = arcless_rad(swings.limits().curvature_per_m, swings.limits());
  if (std::min(first, deflection_rad - first) < least) return std::nullopt;  // of the shallowest dip
  const double dip = dip_of(apart, swings);
  if (std::min(first, deflection_rad - first) < arcless_rad(dip, swings.limits())) return std::nullopt;
  const Point middle = (1 / apart) * between;
  return Dip{dip, first, deflection_rad - first, middle, turned(mirrored(middle), ahead)};
}

/// The dip with two equal halves that leads as far as the goal is away.
std::optional<Dip> even_dip(const Pose& goal, double deflection_rad, const Swings& swings) {
  const CurveLimits& limits = swings.limits();
  const double half = deflection_rad / 2;
  const double apart = length_m(goal.at);
  const double most = std::min(limits.curvature_per_m, std::sqrt(limits.sharpness_per_m2 * deflection_rad));
  const RootEnd closest{most, swings.chord(deflection_rad).length_m - apart};
  if (closest.y > 0) return std::nullopt;
  const Point along = unit(half);
  const auto excess = [&](double dip) {
    return 2 * dot(way_of(*half_of(dip, half, limits), dip, half, swings), along) - apart;
  };
  const RootEnd widest{0, excess(0)};
  if (widest.y < 0) return std::nullopt;
  return Dip{root_between(widest, closest, excess), half, half, along, along};
}

/// Brought to the goal by Newton steps in the dip and in how the deflection is split.
std::optional<Dip> polished(Dip dip, const Pose& goal, const Swings& swings) {
  const CurveLimits& limits = swings.limits();
  const double deflection = dip.first_rad + dip.second_rad;
  const auto miss_of = [&](double q, double first) -> std::optional<Point> {
    const auto way =
        way_of(Dip{.dip_per_m = q, .first_rad = first, .second_rad = deflection - first}, swings);
    if (!way) return std::nullopt;
    return *way - goal.at;
  };
  const double dq = 1e-6 * limits.curvature_per_m;
  const double dfirst = 1e-6;
  for (int i = 0; i < 12; ++i) {
    const auto miss = miss_of(dip.dip_per_m, dip.first_rad);
    if (!miss) return std::nullopt;
    const bool met = length_m(*miss) < kMet_m;
    const double back = dip.dip_per_m > dq ? -dq : dq;  // towards 0, where every dip exists
    const auto by_dip = miss_of(dip.dip_per_m + back, dip.first_rad);
    const auto by_first = miss_of(dip.dip_per_m, dip.first_rad + dfirst);
    if (!by_dip || !by_first) return std::nullopt;
    const Point a = (1 / back) * (*by_dip - *miss);
    const Point b = (1 / dfirst) * (*by_first - *miss);
    const double scale = cross(a, b);
    if (scale == 0) return std::nullopt;
    dip.dip_per_m = std::clamp(dip.dip_per_m - cross(*miss, b) / scale, 0.0, limits.curvature_per_m);
    dip.first_rad -= std::clamp(cross(a, *miss) / scale, -0.3, 0.3);
    dip.second_rad = deflection - dip.first_rad;
    if (met) {  // with one more step, down to rounding
      dip.first = unit(dip.first_rad);
      dip.second = unit(dip.second_rad);
      return dip;
    }
  }
  return std::nullopt;
}

/// The dip to the left that reaches the goal.
std::optional<Dip> dip_to(const Pose& goal, const Swings& swings) {
  const double deflection = whole_turns_off(goal.heading_rad);
  const double most_m = 6 * swings.reach_m();
  if (deflection < 1e-6 || dot(goal.at, goal.at) > most_m * most_m) return std::nullopt;
  const bool wrong_side = std::abs(deflection - std::numbers::pi) < 1e-6 && goal.at.y_m < 0;
  if (wrong_side) return std::nullopt;  // a U-turn leads to the side that it turns to
  if (const auto dip = dip_between_arcs(goal, deflection, swings)) return dip;
  const auto even = even_dip(goal, deflection, swings);
  return even ? polished(*even, goal, swings) : std::nullopt;
}

void add(std::vector<Word>& words, const UTurn& turn, const Swings& swings) {
  for (const int side : {1, -1}) {
    const auto dip = dip_to(side > 0 ? turn.goal : mirrored(turn.goal), swings);
    if (!dip) continue;
    Word& word = words.emplace_back();
    word.before_m = turn.before_m;
    word.dip = *dip;
    word.dip->side = side;
    word.after_m = turn.after_m;
  }
}

/// Draws curves of a left turn, mirrored for side -1; crumbs are left out.
struct Sided {
  Drawn& drawn;
  double side;

  void ramp(Ramp ramp) const {
    if (ramp.length_m <= kNoCurve_m) return;
    ramp.curvature_per_m *= side;
    ramp.sharpness_per_m2 *= side;
    ramp.way.y_m *= side;
    ramp.turn.y_m *= side;
    draw_ramp(drawn, ramp);
  }
  void arc(double curvature_per_m, double length_m, Point turn) const {
    if (length_m > kNoCurve_m) draw_arc(drawn, side * curvature_per_m, length_m, {turn.x_m, side * turn.y_m});
  }
};

}  // namespace

double length_m(const Dip& dip, const CurveLimits& limits) {
  double sum = 0;
  for (const double deflection : {dip.first_rad, dip.second_rad})
    if (const auto half = half_of(dip.dip_per_m, deflection, limits))
      sum += half->up_m + half->arc_m + half->down_m;
  return sum;
}

void draw_dip(Drawn& drawn, const Dip& dip, const Swings& swings) {
  const auto first = half_of(dip.dip_per_m, dip.first_rad, swings.limits());
  const auto second =
      dip.second_rad == dip.first_rad ? first : half_of(dip.dip_per_m, dip.second_rad, swings.limits());
  if (!first || !second) return;
  const Rise low = rise_to(dip.dip_per_m, swings);
  const Rise peak = rise_to(first->peak_per_m, swings);
  const Rise next_peak = rise_to(second->peak_per_m, swings);
  const double g = swings.limits().sharpness_per_m2;
  const Sided draw{drawn, static_cast<double>(dip.side)};
  draw.ramp({0, g, first->up_m, turned(peak.turn, peak.way), peak.turn});
  const Rise down = between(low, peak);
  draw.arc(first->peak_per_m, first->arc_m, turned(dip.first, mirrored(turned(peak.turn, down.turn))));
  draw.ramp({first->peak_per_m, -g, first->down_m, turned(down.turn, mirrored(down.way)), down.turn});
  const Rise up = second->peak_per_m == first->peak_per_m ? down : between(low, next_peak);
  draw.ramp({second->peak_per_m - g * second->down_m, g, second->down_m, up.way, up.turn});
  draw.arc(second->peak_per_m, second->arc_m, turned(dip.second, mirrored(turned(next_peak.turn, up.turn))));
  draw.ramp({second->peak_per_m, -g, second->up_m, mirrored(next_peak.way), next_peak.turn});
}

void dip_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  const auto turn = u_turn(goal);
  if (turn && turn->opposite && turn->before_m + turn->after_m == 0) {
    add(words, *turn, swings);
    return;
  }
  add(words, {.goal = goal}, swings);
  if (turn && turn->before_m + turn->after_m > 0) add(words, *turn, swings);
}

}  // namespace selion
