// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "selion/field/field.hpp"

namespace selion {

enum class AxisOrder { lonlat, latlon };

struct ReadOptions {
  std::optional<std::string> layer;
  std::optional<std::string> crs;      ///< of files that do not say
  AxisOrder axis = AxisOrder::lonlat;  ///< of CSV and text files without a header that says
  std::optional<std::string> field;    ///< one feature, by name or number
  std::optional<std::filesystem::path> obstacles;
  std::optional<std::filesystem::path> gates;
  std::optional<double> accept_datum_error_m;
};

/// Fields of any vector file that GDAL reads, zipped shapefiles and CSV or text of WGS84 coordinates among
/// them; "-" is GeoJSON on `standard_input`. Gates and obstacles come from layers so named, from features
/// with a property `selion` = obstacle | gate | no_go | water, and from the files in the options.
/// @returns at least one field, in file order.
/// @throws InputError naming file, feature, ring and coordinate, and what to do.
std::vector<Field> read_fields(const std::filesystem::path& path, const ReadOptions& options,
                               std::istream& standard_input);

}  // namespace selion
