// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace selion {

/// Of an OGRSpatialReferenceH or null: a code where the definition is, beyond doubt, one of EPSG's, else WKT.
/// Absent: the file has no usable CRS.
std::optional<std::string> crs_definition(void* srs);

/// Whether GDAL gives y (northing, latitude) first. Vector drivers give x first, whatever the CRS says,
/// unless they say that they do not.
bool northing_first(void* srs);

}  // namespace selion
