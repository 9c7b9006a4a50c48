// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <optional>

#include "raw.hpp"

namespace selion {

/// A field file whose features are read one at a time, as often as wanted.
struct RawStream {
  RawFile about;  ///< its layers without their features
  std::function<void(std::size_t layer)> rewind;
  std::function<std::optional<RawFeature>()> next;  ///< of the layer last rewound
  /// Any feature of a layer by its id, to be called `number`; the place in the layer is kept.
  std::function<std::optional<RawFeature>(std::size_t layer, std::int64_t id, int number)> at;
};

/// The same features as read_raw gives. Formats that GDAL reads in place (GeoPackage, FlatGeobuf, shapefile,
/// geodatabase and the like) are never held in memory; text, JSON, XML and archives are.
RawStream raw_stream(const std::filesystem::path& path, const ReadOptions& options,
                     std::istream& standard_input);

/// Absent where GDAL does not read the file in place.
std::optional<RawStream> stream_with_gdal(const std::filesystem::path& file, const std::string& label);

}  // namespace selion
