// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "task.hpp"

namespace selion {

/// Where along which part of a ring with filled corners something is.
struct PartPlace {
  std::size_t part = 0;
  double s_m = 0;
};
/// Absent where the pose lies on no straight of the parts.
std::optional<PartPlace> place_on(const HeadlandPass& ring, const Pose& pose);

/// A part of such a ring, or some of one: driven as laid, for the parts lead on to each other.
Task part_task(const HeadlandPass& ring, const Path& path);

/// The first piece of such a ring, from a station on to the end of its part: as a closed pass it may be begun
/// all around.
Task cut_ring_task(const Terrain& terrain, const HeadlandPass& ring, const std::optional<Pose>& here,
                   const std::vector<Point>& then_to);

}  // namespace selion
