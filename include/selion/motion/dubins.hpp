// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/core/point.hpp"

namespace selion {

/// Length of the shortest way from pose to pose, forwards only, that bends no tighter than `radius_m` but may
/// change its curvature at once (Dubins 1957; the six words as in Shkel and Lumelsky 2001). No drivable path
/// is shorter.
double dubins_length_m(const Pose& from, const Pose& to, double radius_m);

}  // namespace selion
