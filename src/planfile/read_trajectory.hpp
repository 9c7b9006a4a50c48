// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "json_node.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

/// @throws InputError naming the place where the feature is no trajectory of a plan file.
TrajectoryRecord read_trajectory(const JsonNode& feature);

}  // namespace selion
