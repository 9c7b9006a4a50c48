// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/core/point.hpp"
#include "selion/verify/verify.hpp"

namespace selion::verifying {

/// What a feature is by its attribute `selion` or the name of its layer.
enum class OwnerRole { field, obstacle, water, gate };

/// A polygon feature of a file, in WGS84, as OGR gives it.
struct OwnerFeature {
  std::string name;  ///< of the first attribute that reads like one; else empty
  OwnerRole role = OwnerRole::field;
  long long number = 0;  ///< from 1 in its layer
  std::vector<LonLatArea> parts;
};

/// All polygons of the file's layers (or of the one named).
/// @throws InputError where there are none, or OGR cannot read the file.
std::vector<OwnerFeature> read_owner_file(const GivenField& given);

}  // namespace selion::verifying
