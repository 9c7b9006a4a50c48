// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/core/json_writer.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

/// @throws std::logic_error where the record breaks a rule of the plan file.
void write_trajectory(JsonWriter& json, const TrajectoryRecord& trajectory);

}  // namespace selion
