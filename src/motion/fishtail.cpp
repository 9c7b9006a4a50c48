// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "families.hpp"
#include "offer.hpp"

namespace selion {
namespace {

constexpr double kLeastBack_m = 0.01;  // a shorter way back is not worth two changes of gear

bool sensible(const Word& word) {
  return word.line_m < -kLeastBack_m && std::abs(word.swings[0].rad) < std::numbers::pi &&
         std::abs(word.swings[1].rad) < std::numbers::pi;
}

void add(std::vector<Word>& words, const UTurn& turn, const Swings& swings) {
  std::vector<Word> all;
  for (const int first : {1, -1})
    for (const int second : {1, -1}) add_swings_on_a_line(all, turn.goal, first, second, swings);
  for (Word& word : all) {
    if (!sensible(word)) continue;
    word.before_m = turn.before_m;
    word.after_m = turn.after_m;
    words.push_back(word);
  }
}

}  // namespace

void fishtail_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  add(words, {.goal = goal}, swings);
  const auto turn = u_turn(goal);
  if (turn && turn->before_m + std::abs(turn->after_m) > 0) add(words, *turn, swings);
}

}  // namespace selion
