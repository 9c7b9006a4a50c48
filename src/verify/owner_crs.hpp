// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "selion/core/point.hpp"

namespace selion::verifying {

/// Where a file's x and y lie in WGS84. @throws InputError where they lie nowhere.
using ToWgs84 = std::function<LonLat(double x, double y)>;

/// Of coordinates that are longitude and latitude already.
ToWgs84 as_they_are(const std::string& where);

/// What is known of the coordinate system of a layer.
struct OwnerCrs {
  void* of_layer = nullptr;                ///< of OGR; null where the file does not say
  std::optional<std::string> usual = {};   ///< of files of its format that do not say
  std::optional<std::string> option = {};  ///< as --crs names it
  std::string where = {};                  ///< file and layer, for messages
};

/// By OGR, and not before the first place is asked for: layers without fields need no system.
/// @throws InputError, then, where neither file nor option names one, or both and not the same.
ToWgs84 to_wgs84_of(const OwnerCrs& crs);

}  // namespace selion::verifying
