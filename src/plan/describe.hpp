// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "records.hpp"
#include "selion/plan/job.hpp"
#include "selion/plan/plan.hpp"

namespace selion {

/// A plan that holds the field, the job, the frame, what is assumed and what must be warned of, but no block
/// yet.
Plan described(const Field& field, const Job& job, const LocalFrame& frame, const Blocks& cleaned);

BlockReport report_of(const PlannedBlock& planned, const Drive& drive, const LocalFrame& frame,
                      const Job& job);
BlockReport refused(const Block& block, const Infeasible& why);
std::vector<std::string> notes_of(const PlannedBlock& planned);
/// "block 2: " where there are several, else nothing.
std::string block_name(const Block& block, const Blocks& all);
/// Index of the gate that `start` ("gate:2") names; the first one where it names none of the block's. Absent
/// where the block has no gate.
std::optional<std::size_t> gate_of(const Block& block, const std::string& start);

/// @throws InputError where `start` names a gate that no block has.
void check_start(const Blocks& blocks, const std::string& start);

/// Sums of all blocks into the plan file's summary, and the warnings that come of them.
void summarise(Plan& plan);

}  // namespace selion
