// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "selion/layout/layout.hpp"

namespace selion {

/// A straight side of a closed pass and the bend that leads to the next one.
struct RingLeg {
  Stretch side;
  Path bend;
};
/// All around; straights shorter than `least_side_m` are parts of bends. Empty where there is no side.
std::vector<RingLeg> legs_of(const Path& closed, double least_side_m);

/// A bend to the left all along, between sides whose lines cross in one corner.
struct LeftTurn {
  Pose in;              ///< where the bend begins
  Pose out;             ///< where it ends
  double turn_rad = 0;  ///< in (0, pi)
  double before_m = 0;  ///< from the bend's begin on to the corner
  double after_m = 0;   ///< from the corner on to the bend's end
};
std::optional<LeftTurn> left_turn(const Path& bend);

/// How a corner is filled.
struct Fill {
  double on_m = 0;    ///< worked straight on beyond the bend's begin
  double back_m = 0;  ///< the next side is begun so much before the bend's end
  bool round = true;  ///< the bend is worked too
  Path way{};         ///< where it is not: tool up, from the end of the one to the begin of the other
};

/// Straight ahead of a pose, behind it where negative.
Pose on_from(const Pose& pose, double by_m);
/// Straight by `by_m` from a pose, backwards where negative; empty where it is nothing.
Path straight(const Pose& from, double by_m);

/// The ring cut at the bends that have a fill, into parts in the order in which they are driven.
/// @pre a fill or none for each leg, at least one.
std::vector<HeadlandPart> cut(const std::vector<RingLeg>& legs,
                              const std::vector<std::optional<Fill>>& fills);

}  // namespace selion
