// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/planfile/planfile.hpp"

/// A plan file with every kind of record, an obstacle, a hole, a gate with and one without width, two blocks,
/// reverse pieces, a pivot and a wait. Its numbers have no more digits than the file keeps.
selion::PlanFile sample_plan();

/// `text` with the first `from` replaced by `to`; `from` must be there.
std::string replaced(std::string text, const std::string& from, const std::string& to);
