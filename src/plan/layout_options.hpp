// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/field/block.hpp"
#include "selion/field/frame.hpp"
#include "selion/layout/layout.hpp"
#include "selion/plan/job.hpp"

namespace selion {

/// What the job says of a layout, for this block: the driving direction chosen, an AB line in its frame.
/// @throws InputError where an AB line lies nowhere near the block.
Result<LayoutOptions> layout_options(const Block& block, const LocalFrame& frame, const Job& job);

}  // namespace selion
