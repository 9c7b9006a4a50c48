// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/geometry/polygon.hpp"

namespace selion {

/// `ring` with fewer corners, each dropped one within `tolerance_m` of the new ring (Douglas and Peucker
/// 1973).
/// @returns the ring itself where fewer than three corners would be left.
Ring simplified(const Ring& ring, double tolerance_m);

}  // namespace selion
