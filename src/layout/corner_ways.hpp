// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parts.hpp"
#include "ring_legs.hpp"

namespace selion {

/// Is the bend as tight as a corner's? Along a curve of the border the lines of sides meet far away.
bool is_corner(const Ground& ground, const LeftTurn& turn);

/// How far the machine can work straight on beyond the bend's begin and get away again, up to where its tool
/// passes the corner of the lanes.
double farthest_on_m(const Ground& ground, const LeftTurn& turn);

/// How far before the bend's end it can come to and begin the next side.
double farthest_back_m(const Ground& ground, const LeftTurn& turn);

/// The room beside a bend.
struct Sides {
  double before_m = 0;
  double after_m = 0;
};

/// The way with the tool up from the end of one side to the begin of the next, both as `fill` has them, with
/// no more room than the sides give: for a machine that may reverse back, round and back, for one that may
/// not one turn. Absent where there is none.
std::optional<Path> way_round(const Ground& ground, const LeftTurn& turn, const Path& bend, const Fill& fill,
                              const Sides& sides);

}  // namespace selion
