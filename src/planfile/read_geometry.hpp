// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "json_node.hpp"
#include "rules.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

// The geometry of a feature. Each throws an InputError where it is of another type or breaks a rule of the
// plan file.

LonLat read_point(const JsonNode& feature);
LonLatLine read_line(const JsonNode& feature);
/// Of a Polygon or MultiPolygon; rings lose their closing corner.
std::vector<LonLatArea> read_parts(const JsonNode& feature);

/// @throws InputError at `node` where there is a problem.
void check(const JsonNode& node, const Problem& problem);

}  // namespace selion
