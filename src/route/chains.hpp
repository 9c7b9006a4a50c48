// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/layout/layout.hpp"

namespace selion {

/// Swath pieces that lie side by side without a gap, in strip order: one back-and-forth.
using Chain = std::vector<const Swath*>;

/// Splits the pieces into chains: a chain ends where a strip falls into pieces, or pieces join (a hole, a
/// bay). Choset 2000's cells, met at the strips instead of at sweep lines.
std::vector<Chain> chains_of(const std::vector<Swath>& swaths, DrivingDirection along);

}  // namespace selion
