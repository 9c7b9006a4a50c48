// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "selion/output/map.hpp"
#include "selion/plan/plan.hpp"

namespace selion {

/// report.json: the figures, assumptions, notes and uncovered places of a plan, as docs/report.md describes
/// them.
std::string report_json(const Plan& plan);

/// What the map of this plan says: title, data box, notes, assumptions and warnings, in the units asked for.
MapText map_text(const Plan& plan, const Job& job);

/// Paper and units of the map, as the job has them.
MapOptions map_options(const Job& job);

}  // namespace selion
