// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geos.hpp"
#include "owner_file.hpp"
#include "plane.hpp"

namespace selion::verifying {

/// What an owner's rings enclose, by the rules of docs/input.md, however they cross or overlap.
struct OwnerGround {
  Shape area;
  Shape holes;  ///< taken off it
};

OwnerGround ground_of(const Plane& plane, const OwnerFeature& feature);
/// Its polygons, circles around its points, bands along its lines.
Shape obstacle_of(const Plane& plane, const OwnerFeature& feature);

}  // namespace selion::verifying
