// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace selion::verifying {

/// Something that OGR has opened.
struct OwnerData {
  std::shared_ptr<void> handle;
  std::string label;  ///< for messages: the file, and which one of an archive
  std::string path;   ///< as OGR opened it
};

/// A file; of an archive all its shapefiles, else KML files and so on. Nothing is written beside it.
/// @throws InputError where OGR can read nothing of it.
std::vector<OwnerData> owner_data(const std::filesystem::path& file);

/// Whether it is GeoJSON that names no coordinate system.
bool is_plain_geojson(const OwnerData& data);

}  // namespace selion::verifying
