// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "selion/motion/turns.hpp"
#include "words.hpp"

namespace selion {

/// Adds a family's words to `goal`, seen from the start.
using WordFamily = void (*)(std::vector<Word>& words, const Pose& goal, const Swings& swings);

/// How Connections asks a family for its words.
enum class Asked {
  first,           ///< they cost next to nothing
  by_lefts,        ///< when a way that turns left by what it has to may be next
  by_rights,       ///< the same to the right
  by_sides,        ///< the same to either side
  when_reversing,  ///< only for machines that may
  when_pivoting,   ///< the same
  step_by_step,    ///< by a search of its own, for three swings: the first one to the left
  step_by_step_right,
};

struct Family {
  TurnKind kind;
  WordFamily words = nullptr;
  Asked asked = Asked::first;
};
/// Between words as long as each other the one of fewer stretches stands first and stays: families overlap, a
/// flat turn is also left, straight, left.
std::span<const Family> families();

void straight_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);
void loop_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);
void dip_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);
void flat_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);
void fishtail_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);
void cusp_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);
void pivot_words(std::vector<Word>& words, const Pose& goal, const Swings& swings);

/// Swing, straight, swing to the sides given.
template <int First, int Second>
void line_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  add_swing_line_swings(words, goal, First, Second, swings);
}

/// Three swings, the first to `Side`.
template <int Side>
void three_words(std::vector<Word>& words, const Pose& goal, const Swings& swings) {
  add_three_swings(words, goal, Side, swings);
}

}  // namespace selion
