// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/core/machine.hpp"
#include "selion/field/block.hpp"

namespace selion {

/// The block cut at the necks through which the machine at full width cannot pass: each zone is planned by
/// itself. The block itself where there is no such neck. Numbers are left as they are.
std::vector<Block> zones_of(const Block& block, const Machine& machine);

}  // namespace selion
