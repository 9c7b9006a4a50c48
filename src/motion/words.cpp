// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.hpp"

#include <algorithm>
#include <cmath>

#include "families.hpp"
#include "offer.hpp"

namespace selion {

Word word_of(const ThreeSwings& d) {
  return {.swings = {deflection(d[0]), deflection(d[1]), deflection(d[2])}};
}

double length_m(const Word& word, const Swings& swings) {
  double sum = word.before_m + std::abs(word.line_m) + word.after_m;
  for (const Deflection& deflection : word.swings)
    if (deflection.rad != 0) sum += swings.length_m(std::abs(deflection.rad));
  if (word.pivots) sum += word.pivots->line_m;
  if (word.cusps) sum += length_m(*word.cusps, swings.limits());
  return word.dip ? sum + length_m(*word.dip, swings.limits()) : sum;
}

void draw_word(Drawn& drawn, const Word& word, const Swings& swings) {
  draw_line(drawn, word.before_m);
  draw_swing(drawn, word.swings[0], swings);
  draw_line(drawn, word.line_m);
  draw_line_back(drawn, -word.line_m);
  draw_swing(drawn, word.swings[1], swings);
  draw_swing(drawn, word.swings[2], swings);
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

void straight_words(std::vector<Word>& words, const Pose& goal, const Swings&) {
  if (goal.at.x_m < -kInLine || std::abs(goal.at.y_m) > kInLine || std::abs(goal.heading_rad) > kInLine)
    return;
  words.push_back({.before_m = std::max(0.0, goal.at.x_m)});
}

bool near_for_three(const Pose& goal, const Swings& swings) {
  return dot(goal.at, goal.at) <= 36 * swings.reach_m() * swings.reach_m();
}

void add_three_swings(std::vector<Word>& words, const Pose& goal, int side, const Swings& swings) {
  if (!near_for_three(goal, swings)) return;
  ThreeSwingSearch search{goal, side, swings};
  std::vector<ThreeSwingSearch::Start> starts;
  for (std::size_t i = 0; i < ThreeSwingSearch::kDiagonals; ++i) search.add_starts(starts, i);
  for (const auto& start : starts)
    if (const auto triple = search.found(start)) words.push_back(word_of(*triple));
}

}  // namespace selion
