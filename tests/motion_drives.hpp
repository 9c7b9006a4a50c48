// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/motion/limits.hpp"

namespace selion {

/// Forty legs end to end, lines, arcs and clothoids of continuous curvature, some through curvature 0, in one
/// gear, each with its own cap up to 6 m/s; the same for the same seed.
std::vector<Leg> winding_legs(unsigned seed);

/// Machines on whose drives steering, lateral acceleration and caps rule in turn.
std::vector<Machine> limited_machines();

/// No limit is exceeded but for rounding.
void check_within(const LimitUse& use);

}  // namespace selion
