// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/path.hpp"

namespace selion {

/// How far the rear axle's centre gets beyond the path's start in the direction `heading_rad`: 0 where it
/// never does or the path is empty. Exact: looked for at the ends of the curves and wherever the driving
/// direction is square to it. With the direction square to a headland's edge, the depth of the headland that
/// the axle needs.
double depth_m(const Path& path, double heading_rad);

}  // namespace selion
