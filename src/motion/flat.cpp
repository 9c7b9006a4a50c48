// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "offer.hpp"

namespace selion {
namespace {

constexpr double kPi = std::numbers::pi;

/// Quarter turn, straight, quarter turn, where the headings are opposite but for rounding.
void add_quarters(std::vector<Word>& words, double aside_m, const Swings& swings) {
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  const double side = aside_m > 0 ? 1 : -1;
  const double line_m =
      std::abs(aside_m) - std::numbers::sqrt2 * swings.chord(kPi / 2, {kHalf, kHalf}).length_m;
  if (line_m < 0) return;
  const Deflection quarter{side * kPi / 2, {kHalf, side * kHalf}};
  words.push_back({.swings = {quarter, quarter, {}}, .line_m = line_m});
}

}  // namespace

void flat_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  const auto turn = u_turn(goal);
  if (!turn) return;
  const auto before = static_cast<std::ptrdiff_t>(words.size());
  if (turn->opposite) {
    add_quarters(words, turn->goal.at.y_m, swings);
  } else {
    const int side = turn->goal.at.y_m > 0 ? 1 : -1;
    add_swing_line_swings(words, turn->goal, side, side, swings);
    words.erase(std::remove_if(words.begin() + before, words.end(),
                               [](const Word& word) {
                                 return std::max(std::abs(word.swings[0].rad), std::abs(word.swings[1].rad)) >
                                        kPi;
                               }),
                words.end());
  }
  std::for_each(words.begin() + before, words.end(), [&turn](Word& word) {
    word.before_m = turn->before_m;
    word.after_m = turn->after_m;
  });
}

}  // namespace selion
