// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.hpp"

#include <algorithm>
#include <cmath>

#include "families.hpp"
#include "offer.hpp"

namespace selion {

double length_m(const Word& word, const Swings& swings) {
  double sum = word.before_m + std::abs(word.line_m) + word.after_m;
  for (const double deflection : word.swings_rad)
    if (deflection != 0) sum += swings.length_m(std::abs(deflection));
  if (word.pivots) sum += word.pivots->line_m;
  if (word.cusps) sum += length_m(*word.cusps, swings.limits());
  return word.dip ? sum + length_m(*word.dip, swings.limits()) : sum;
}

void draw_word(Drawn& drawn, const Word& word, const Swings& swings) {
  draw_line(drawn, word.before_m);
  draw_swing(drawn, word.swings_rad[0], swings);
  draw_line(drawn, word.line_m);
  draw_line_back(drawn, -word.line_m);
  draw_swing(drawn, word.swings_rad[1], swings);
  draw_swing(drawn, word.swings_rad[2], swings);
  if (word.dip) draw_dip(drawn, *word.dip, swings);
  if (word.pivots) {
    draw_pivot(drawn, word.pivots->first_rad);
    draw_line(drawn, word.pivots->line_m);
    draw_pivot(drawn, word.pivots->second_rad);
  }
  if (word.cusps) draw_cusps(drawn, *word.cusps, swings);
  draw_line(drawn, word.after_m);
  if (drawn.path.empty()) drawn.path.push_back({{drawn.at.at, drawn.at.heading_rad, 0, 0, 0}, Gear::forward});
}

std::vector<Word> straight_words(const Pose& goal, const Swings&) {
  if (goal.at.x_m < -kInLine || std::abs(goal.at.y_m) > kInLine || std::abs(goal.heading_rad) > kInLine)
    return {};
  return {Word{.before_m = std::max(0.0, goal.at.x_m)}};
}

bool near_for_three(const Pose& goal, const Swings& swings) {
  const Point c = swings.centre();
  return dot(goal.at, goal.at) <= 36 * dot(c, c);
}

}  // namespace selion
