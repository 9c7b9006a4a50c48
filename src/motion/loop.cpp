// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "families.hpp"
#include "offer.hpp"

namespace selion {
namespace {

/// Newton steps down to the root of a function that falls ever faster, from a place beyond it.
template <class Excess>
double root_from_beyond(double d, Excess excess) {
  for (int i = 0; i < 30; ++i) {
    const auto [value, slope] = excess(d);
    const double step = value / slope;
    d = std::max(d - step, 0.0);
    if (std::abs(step) < 1e-15) break;
  }
  return d;
}

/// The loop to a swath `width_m` >= 0 aside: away by d, back by pi + 2 d, away by d again.
struct Loop {
  double outer_rad = 0;
  Point outer{1, 0};   ///< unit(outer_rad)
  bool exact = false;  ///< to rounding
};

/// All three swings at the curvature limit: 2 b cos d - 2 a sin d = w / 2 + b.
std::optional<Loop> full_loop(double width_m, const Swings& swings) {
  constexpr double kWellPosed = 0.05;  // for the inverse cosine
  const Point c = swings.centre();
  const double cosine = (width_m / 2 + c.y_m) / (2 * swings.reach_m());
  if (!(cosine < 1)) return std::nullopt;
  const double outer = std::acos(cosine) - swings.lean_rad();
  if (outer < swings.full_rad()) return std::nullopt;
  const double sine = std::sqrt(1 - cosine * cosine);
  const Point lean = (1 / swings.reach_m()) * Point{c.y_m, -c.x_m};
  return Loop{outer, turned(lean, {cosine, sine}), sine > kWellPosed};
}

std::optional<Loop> loop_to(double width_m, const Swings& swings) {
  const double pi = std::numbers::pi;
  if (swings.chord(pi, {0, 1}).length_m < width_m) return std::nullopt;
  if (const auto full = full_loop(width_m, swings)) return full;
  const double most = std::min(swings.full_rad(), pi / 2 - 1e-9);
  const double outer = root_from_beyond(most, [&](double d) {
    const Chord back = swings.chord(pi + 2 * d);
    const Chord away = swings.chord(d);
    const Point half = unit(d / 2);
    return std::pair{
        back.length_m - 2 * away.length_m * half.y_m - width_m,
        2 * back.slope_m_per_rad - 2 * away.slope_m_per_rad * half.y_m - away.length_m * half.x_m};
  });
  return Loop{outer, unit(outer), false};
}

std::optional<Word> word_for(const Loop& loop, double side, const UTurn& turn, const Swings& swings) {
  if (turn.opposite && loop.exact) {
    const double cosine = std::sqrt((1 + loop.outer.x_m) / 2);
    const Deflection away{-side * loop.outer_rad, {cosine, -side * loop.outer.y_m / (2 * cosine)}};
    const Deflection back{side * (std::numbers::pi + 2 * loop.outer_rad),
                          {-loop.outer.y_m, side * loop.outer.x_m}};
    return Word{.swings = {away, back, away}};
  }
  const double back = side * (std::numbers::pi + 2 * loop.outer_rad);
  const auto swung = polished({-side * loop.outer_rad, back, -side * loop.outer_rad}, turn.goal, swings);
  if (!swung) return std::nullopt;
  return word_of(*swung);
}

}  // namespace

void loop_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  const auto turn = u_turn(goal);
  if (!turn) return;
  const double aside = turn->goal.at.y_m;
  const auto loop = loop_to(std::abs(aside), swings);
  if (!loop) return;
  for (const double side : {1.0, -1.0}) {
    if (side * aside < 0) continue;
    auto word = word_for(*loop, side, *turn, swings);
    if (!word) continue;
    word->before_m = turn->before_m;
    word->after_m = turn->after_m;
    words.push_back(*word);
  }
}

}  // namespace selion
