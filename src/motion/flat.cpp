// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "offer.hpp"

namespace selion {

std::vector<Word> flat_words(const Pose& goal, const Swings& swings) {
  const auto turn = u_turn(goal);
  if (!turn) return {};
  const int side = turn->goal.at.y_m > 0 ? 1 : -1;
  std::vector<Word> words = swing_line_swings(turn->goal, side, side, swings);
  std::erase_if(words, [](const Word& word) {
    return std::abs(word.swings_rad[0]) > std::numbers::pi || std::abs(word.swings_rad[1]) > std::numbers::pi;
  });
  for (Word& word : words) {
    word.before_m = turn->before_m;
    word.after_m = turn->after_m;
  }
  return words;
}

}  // namespace selion
