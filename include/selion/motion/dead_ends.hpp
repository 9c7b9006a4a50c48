// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/footprint.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// Can a machine come to the pose forwards (or drive on from it forwards) by some turn that leads off its
/// line? A look around by a few plain turns: enough to keep a machine that may not reverse out of corners in
/// which it would be stuck.
bool has_way_in(const FreeSpace& space, const Footprint& footprint, const Swings& swings, const Pose& pose);
bool has_way_out(const FreeSpace& space, const Footprint& footprint, const Swings& swings, const Pose& pose);

}  // namespace selion
