// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "records.hpp"
#include "selion/core/error.hpp"
#include "selion/core/progress.hpp"
#include "selion/plan/job.hpp"

namespace selion {

/// Lays a block out and drives it; with fewer headland passes than the job leaves open, with passes alone,
/// with its corners rounded, or with the outermost passes further off its border, where that covers more.
Result<PlannedBlock> plan_block(const Block& block, const LocalFrame& frame, const Job& job,
                                const Progress& progress);

}  // namespace selion
