// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/core/machine.hpp"
#include "selion/geometry/free_space.hpp"
#include "selion/geometry/polygon.hpp"
#include "selion/motion/path.hpp"

namespace selion {

/// What must stay inside: the body's rectangle and the tool's line at full width, in the vehicle's frame.
struct Footprint {
  double front_m = 0;
  double rear_m = 0;
  double half_body_m = 0;
  double tool_x_m = 0;
  double half_tool_m = 0;

  friend bool operator==(const Footprint&, const Footprint&) = default;
};

Footprint footprint_of(const Machine& machine);
/// Farthest point of the footprint from the rear axle's centre.
double reach_m(const Footprint& footprint);

/// `area` indexed for this footprint.
FreeSpace free_space(const Polygon& area, const Footprint& footprint);

/// Does all of the footprint stay inside while the vehicle drives the path? To within half a centimetre.
bool fits(const FreeSpace& space, const Footprint& footprint, const Path& path);
bool fits(const FreeSpace& space, const Footprint& footprint, const Pose& pose);
/// The same where the path is known to begin inside.
bool stays_inside(const FreeSpace& space, const Footprint& footprint, const Path& path);

/// What the tool at full width sweeps: simple rings, anticlockwise, joined edge to edge; curves as chords
/// within 3 mm.
std::vector<Ring> swept_by_tool(const Footprint& footprint, const Path& path);

}  // namespace selion
