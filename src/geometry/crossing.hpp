// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/core/point.hpp"

namespace selion {

/// How the ray from p to the east meets an edge: every crossing changes inside to outside.
enum class RayMeets { nothing, crossing, the_edge_at_p };

/// Decided by the exact sign of the turn a -> b -> p; an edge holds its lower end only, so that a ray through
/// a corner counts once.
RayMeets ray_meets(Point a, Point b, Point p);

}  // namespace selion
