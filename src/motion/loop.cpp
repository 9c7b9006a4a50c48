// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "offer.hpp"
#include "root.hpp"
#include "words.hpp"

namespace selion {
namespace {

/// The loop to a swath `width_m` >= 0 aside: away by d, back by pi + 2 d, away by d again.
std::optional<double> outer_deflection(double width_m, const Swings& swings) {
  const double pi = std::numbers::pi;
  const auto excess = [&](double d) {
    return swings.chord(pi + 2 * d).length_m - 2 * swings.chord(d).length_m * std::sin(d / 2) - width_m;
  };
  const RootEnd least{0, excess(0)};
  const double most = pi / 2 - 1e-9;
  if (least.y < 0) return std::nullopt;
  return root_between(least, {most, excess(most)}, excess);
}

}  // namespace

std::vector<Path> loop_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const auto turn = u_turn(from, to);
  if (!turn) return {};
  const Swings swings{limits};
  const double aside = turn->goal.at.y_m;
  const auto outer = outer_deflection(std::abs(aside), swings);
  std::vector<Path> paths;
  for (const double side : {1.0, -1.0}) {
    if (!outer || side * aside < 0) continue;
    const ThreeSwings start{-side * *outer, side * (std::numbers::pi + 2 * *outer), -side * *outer};
    const auto swung = polished(start, turn->goal, swings);
    if (!swung) continue;
    Drawn drawn{{}, from};
    draw_line(drawn, turn->before_m);
    draw_swings(drawn, *swung, swings);
    draw_line(drawn, turn->after_m);
    offer(paths, std::move(drawn), to, limits);
  }
  return paths;
}

}  // namespace selion
