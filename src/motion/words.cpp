// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.hpp"

#include <algorithm>

#include "families.hpp"
#include "offer.hpp"

namespace selion {
namespace {

template <int First, int Second>
std::vector<Path> with_line(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const Swings swings{limits};
  std::vector<Path> paths;
  for (const SwingLineSwing& word : swing_line_swings(seen_from(from, to), First, Second, swings)) {
    Drawn drawn{{}, from};
    draw_swing(drawn, word.first_rad, swings);
    draw_line(drawn, word.line_m);
    draw_swing(drawn, word.second_rad, swings);
    offer(paths, std::move(drawn), to, limits);
  }
  return paths;
}

template <int Side>
std::vector<Path> of_three(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const Swings swings{limits};
  std::vector<Path> paths;
  for (const ThreeSwings& word : three_swings(seen_from(from, to), Side, swings)) {
    Drawn drawn{{}, from};
    draw_swings(drawn, word, swings);
    offer(paths, std::move(drawn), to, limits);
  }
  return paths;
}

}  // namespace

std::vector<Path> straight_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const double ahead = std::max(0.0, seen_from(from, to).at.x_m);
  Drawn drawn{{}, from};
  draw(drawn, 0, 0, ahead);
  std::vector<Path> paths;
  offer(paths, std::move(drawn), to, limits);
  return paths;
}

std::vector<Path> lsl_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  return with_line<1, 1>(from, to, limits);
}
std::vector<Path> rsr_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  return with_line<-1, -1>(from, to, limits);
}
std::vector<Path> lsr_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  return with_line<1, -1>(from, to, limits);
}
std::vector<Path> rsl_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  return with_line<-1, 1>(from, to, limits);
}
std::vector<Path> lrl_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  return of_three<1>(from, to, limits);
}
std::vector<Path> rlr_turn(const Pose& from, const Pose& to, const CurveLimits& limits) {
  return of_three<-1>(from, to, limits);
}

}  // namespace selion
