// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "selion/core/point.hpp"
#include "selion/verify/verify.hpp"

namespace selion::verifying {

/// What a feature is by its attribute `selion` or the name of its layer.
enum class OwnerRole { field, obstacle, no_go, water, gate };
bool is_obstacle(OwnerRole role);

/// A feature of a file, in WGS84, as OGR gives it.
struct OwnerFeature {
  std::string where;  ///< file, layer and number, for messages
  std::string name;   ///< of the first attribute that reads like one; else empty
  OwnerRole role = OwnerRole::field;
  long long number = 0;  ///< from 1 in its layer
  std::vector<LonLatArea> parts;
  std::vector<LonLatLine> lines;   ///< of obstacles, as their points
  std::vector<LonLat> points;      ///< of obstacles and gates
  std::optional<double> radius_m;  ///< of an obstacle's points: there where they are
  std::optional<double> width_m;   ///< of lines and gates
};

/// Fields, obstacles and gates of the file and of those with further obstacles and gates.
/// @throws InputError where there is no field, or a file cannot be read.
std::vector<OwnerFeature> read_owner_file(const GivenField& given);

}  // namespace selion::verifying
