// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/route/route.hpp"

namespace selion {

/// Ways backwards over what was just driven, longer and longer, 150 m at most: out of a dead end the way it
/// came is always free.
std::vector<Path> retreats(const std::vector<RoutePiece>& driven);

}  // namespace selion
