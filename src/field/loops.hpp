// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/geometry/polygon.hpp"

namespace selion {

/// Corners nearer than this are one; a corner nearer than this to an edge lies on it.
constexpr double kSnap_m = 1e-3;

/// Corners of all rings within kSnap_m of an earlier one moved onto it, repeated corners dropped, and corners
/// that touch an edge of any ring made corners of that ring too: what touched roughly now touches exactly.
/// @returns how many corners were dropped.
int snap(std::vector<Ring>& rings);

/// A stretch of border that goes out and comes back along itself.
struct Spike {
  Point foot;
  Point tip;
};
/// Drops the spikes of a snapped ring.
std::vector<Spike> drop_spikes(Ring& ring);

/// A part of a ring that returns to where it started.
struct Loop {
  Ring ring;    ///< no corner twice
  Point pinch;  ///< where it closes: a crossing or touching place of the ring, unless it is the whole of it
};

/// The ring cut at every place where it crosses or touches itself (snapped rings only). Zero-width spikes
/// come out as loops of two corners. @returns at least one loop for a ring with corners.
std::vector<Loop> loops_of(const Ring& ring);

}  // namespace selion
