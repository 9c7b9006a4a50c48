// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "offer.hpp"
#include "words.hpp"

namespace selion {

std::vector<Path> flat_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const auto turn = u_turn(from, to);
  if (!turn) return {};
  const Swings swings{limits};
  const int side = turn->goal.at.y_m > 0 ? 1 : -1;
  std::vector<Path> paths;
  for (const SwingLineSwing& word : swing_line_swings(turn->goal, side, side, swings)) {
    if (std::abs(word.first_rad) > std::numbers::pi || std::abs(word.second_rad) > std::numbers::pi) continue;
    Drawn drawn{{}, from};
    draw_line(drawn, turn->before_m);
    draw_swing(drawn, word.first_rad, swings);
    draw_line(drawn, word.line_m);
    draw_swing(drawn, word.second_rad, swings);
    draw_line(drawn, turn->after_m);
    offer(paths, std::move(drawn), to, limits);
  }
  return paths;
}

}  // namespace selion
