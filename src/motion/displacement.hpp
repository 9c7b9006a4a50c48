// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/path.hpp"

namespace selion {

/// From the start of the curve to its point at `s_m` (which may lie outside [0, length]), in the curve's
/// frame of reference. The error stays near 1e-16 of the way driven, with no seam between lines, arcs and
/// clothoids.
Point displacement(const Curve& curve, double s_m);

/// The directions of travel at a curve's start and at its point.
struct EndDirections {
  Point first;
  Point last;
};
/// The same for callers that have the directions at hand.
Point displacement(const Curve& curve, double s_m, const EndDirections& ends);

/// How far the heading turns from the curve's start to `s_m`.
double turned_rad(const Curve& curve, double s_m);

}  // namespace selion
