// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <utility>

#include "families.hpp"
#include "offer.hpp"
#include "selion/motion/turns.hpp"

namespace selion {
namespace {

template <std::vector<Word> (*Words)(const Pose&, const Swings&)>
std::vector<Path> drawn(const Pose& from, const Pose& to, const Swings& swings) {
  std::vector<Path> paths;
  for (const Word& word : Words(seen_from(from, to), swings))
    if (auto path = drawn_to(word, from, to, swings)) paths.push_back(std::move(*path));
  return paths;
}

constexpr auto kTurns = std::to_array<TurnKind>({
    {"straight", "ahead, where the goal lies there", Needs::nothing, drawn<straight_words>},
    {"loop", "an omega to a swath nearer than two turning radii", Needs::nothing, drawn<loop_words>},
    {"dip", "one turn that straightens a little in its middle", Needs::nothing, drawn<dip_words>},
    {"flat", "quarter turn, straight, quarter turn, to a swath further off", Needs::nothing,
     drawn<flat_words>},
    {"fishtail", "ahead in a turn, straight back, ahead in a turn", Needs::reverse, drawn<fishtail_words>},
    {"cusps", "a fishtail whose wheels are steered while it stands", Needs::reverse, drawn<cusp_words>},
    {"pivot", "rotate on the spot, straight, rotate on the spot", Needs::pivot, drawn<pivot_words>},
    {"lsl", "left, straight, left", Needs::nothing, drawn<line_words<1, 1>>},
    {"rsr", "right, straight, right", Needs::nothing, drawn<line_words<-1, -1>>},
    {"lsr", "left, straight, right", Needs::nothing, drawn<line_words<1, -1>>},
    {"rsl", "right, straight, left", Needs::nothing, drawn<line_words<-1, 1>>},
    {"lrl", "left, right, left", Needs::nothing, drawn<three_words<1>>},
    {"rlr", "right, left, right", Needs::nothing, drawn<three_words<-1>>},
});

}  // namespace

Manoeuvres manoeuvres_of(const Machine& machine) {
  return {machine.may_reverse, machine.may_pivot && machine.kind == MachineKind::differential};
}

bool allows(const Manoeuvres& may, Needs needs) {
  return needs == Needs::nothing || (needs == Needs::reverse ? may.reverse : may.pivot);
}

std::span<const TurnKind> turns() { return kTurns; }

}  // namespace selion
