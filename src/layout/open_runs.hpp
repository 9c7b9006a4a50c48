// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "parts.hpp"

namespace selion {

/// The line from a to b in steps short enough that a run ends close to what it cannot pass.
std::vector<Path> steps_along(Point a, Point b);

/// What can be driven of the steps without a gap, where that is worth a pass.
std::vector<HeadlandRun> runs_of(const Ground& ground, const std::vector<Path>& steps);

/// Of a ring that is not to be driven round: chains of its edges, joined by tight corners where these have
/// the room and fit, parted at all others.
std::vector<HeadlandRun> runs_on_edges(const Ground& ground, const Ring& ring, double room_m);

}  // namespace selion
