// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "selion/core/point.hpp"

namespace selion::verifying {

/// Where a file's x and y lie in WGS84. @throws InputError where they lie nowhere.
using ToWgs84 = std::function<LonLat(double x, double y)>;

/// From the coordinate system of a layer of OGR, by OGR.
ToWgs84 to_wgs84_of(void* layer);

}  // namespace selion::verifying
