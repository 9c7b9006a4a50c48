// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "families.hpp"
#include "offer.hpp"
#include "selion/motion/turns.hpp"

namespace selion {
namespace {

template <WordFamily Words>
std::vector<Path> drawn(const Pose& from, const Pose& to, const Swings& swings) {
  const View view{from, to};
  std::vector<Word> words;
  Words(words, view.goal, swings);
  std::vector<Path> paths;
  paths.reserve(words.size());
  for (const Word& word : words)
    if (auto path = drawn_to(word, view, swings)) paths.push_back(std::move(*path));
  return paths;
}

template <WordFamily Words>
constexpr Family family(std::string_view name, std::string_view about, Asked asked) {
  Needs needs = Needs::nothing;
  if (asked == Asked::when_reversing) needs = Needs::reverse;
  if (asked == Asked::when_pivoting) needs = Needs::pivot;
  return {{name, about, needs, drawn<Words>}, Words, asked};
}

constexpr auto kFamilies = std::to_array<Family>({
    family<straight_words>("straight", "ahead, where the goal lies there", Asked::first),
    family<loop_words>("loop", "an omega to a swath nearer than two turning radii", Asked::first),
    family<dip_words>("dip", "one turn that straightens a little in its middle", Asked::first),
    family<flat_words>("flat", "quarter turn, straight, quarter turn, to a swath further off", Asked::first),
    family<line_words<1, 1>>("lsl", "left, straight, left", Asked::by_lefts),
    family<line_words<-1, -1>>("rsr", "right, straight, right", Asked::by_rights),
    family<line_words<1, -1>>("lsr", "left, straight, right", Asked::by_sides),
    family<line_words<-1, 1>>("rsl", "right, straight, left", Asked::by_sides),
    family<fishtail_words>("fishtail", "ahead in a turn, straight back, ahead in a turn",
                           Asked::when_reversing),
    family<cusp_words>("cusps", "a fishtail whose wheels are steered while it stands", Asked::when_reversing),
    family<pivot_words>("pivot", "rotate on the spot, straight, rotate on the spot", Asked::when_pivoting),
    family<three_words<1>>("lrl", "left, right, left", Asked::step_by_step),
    family<three_words<-1>>("rlr", "right, left, right", Asked::step_by_step_right),
});

constexpr auto kTurns = [] {
  std::array<TurnKind, kFamilies.size()> kinds;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = kFamilies[i].kind;
  return kinds;
}();

}  // namespace

std::span<const Family> families() { return kFamilies; }
Manoeuvres manoeuvres_of(const Machine& machine) {
  return {machine.may_reverse, machine.may_pivot && machine.kind == MachineKind::differential};
}

bool allows(const Manoeuvres& may, Needs needs) {
  return needs == Needs::nothing || (needs == Needs::reverse ? may.reverse : may.pivot);
}

std::span<const TurnKind> turns() { return kTurns; }

}  // namespace selion
