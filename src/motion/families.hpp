// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words.hpp"

namespace selion {

/// Swing, straight, swing to the sides given.
template <int First, int Second>
std::vector<Word> line_words(const Pose& goal, const Swings& swings) {
  return swing_line_swings(goal, First, Second, swings);
}

/// Are three swings to a goal worth looking for? Farther off, a straight is shorter.
bool near_for_three(const Pose& goal, const Swings& swings);

template <int Side>
std::vector<Word> three_words(const Pose& goal, const Swings& swings) {
  if (!near_for_three(goal, swings)) return {};
  ThreeSwingSearch search{goal, Side, swings};
  std::vector<ThreeSwingSearch::Start> starts;
  for (std::size_t i = 0; i < ThreeSwingSearch::kDiagonals; ++i) search.add_starts(starts, i);
  std::vector<Word> words;
  for (const auto& start : starts)
    if (const auto triple = search.found(start)) words.push_back({.swings_rad = *triple});
  return words;
}

}  // namespace selion
