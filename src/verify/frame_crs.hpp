// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "plane.hpp"

namespace selion::verifying {

/// Is the plane the one that the job's `frame.crs` names: for `auto` true to scale at its origin, else that
/// code's but for where it begins?
bool is_frame_of(const Plane& plane, LonLat origin, const std::string& crs);

}  // namespace selion::verifying
