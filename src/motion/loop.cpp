// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

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
std::optional<double> outer_deflection(double width_m, const Swings& swings) {
  const double pi = std::numbers::pi;
  if (swings.chord(pi).length_m < width_m) return std::nullopt;
  const Point c = swings.centre();
  // All three at the curvature limit: 2 b cos d - 2 a sin d = w / 2 + b.
  const double reach = length_m(c);
  const double cosine = (width_m / 2 + c.y_m) / (2 * reach);
  const double full = cosine < 1 ? std::acos(cosine) - std::atan2(c.x_m, c.y_m) : -1;
  if (full >= swings.full_rad()) return full;
  const double most = std::min(swings.full_rad(), pi / 2 - 1e-9);
  return root_from_beyond(most, [&](double d) {
    const Chord back = swings.chord(pi + 2 * d);
    const Chord away = swings.chord(d);
    const Point half = unit(d / 2);
    return std::pair{
        back.length_m - 2 * away.length_m * half.y_m - width_m,
        2 * back.slope_m_per_rad - 2 * away.slope_m_per_rad * half.y_m - away.length_m * half.x_m};
  });
}

}  // namespace

std::vector<Word> loop_words(const Pose& goal, const Swings& swings) {
  const auto turn = u_turn(goal);
  if (!turn) return {};
  const double aside = turn->goal.at.y_m;
  const auto outer = outer_deflection(std::abs(aside), swings);
  std::vector<Word> words;
  for (const double side : {1.0, -1.0}) {
    if (!outer || side * aside < 0) continue;
    const ThreeSwings start{-side * *outer, side * (std::numbers::pi + 2 * *outer), -side * *outer};
    const auto swung = polished(start, turn->goal, swings);
    if (swung) words.push_back({turn->before_m, *swung, 0, std::nullopt, turn->after_m});
  }
  return words;
}

}  // namespace selion
