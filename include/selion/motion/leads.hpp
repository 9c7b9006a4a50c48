// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/motion/turns.hpp"

namespace selion {

/// Wide swings by little off a pose to either side, the tightest first, and onto one: the front of a machine
/// that steers tightly at the border swings out over it, one that has first been led away has room.
std::vector<Path> leads_off(const Pose& from, const CurveLimits& limits);
std::vector<Path> leads_onto(const Pose& to, const CurveLimits& limits);

}  // namespace selion
