// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/plan/plan.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

/// What the independent check says of a plan, as it was read back from its file.
Verification verification_of(const PlanFile& plan);

}  // namespace selion
