// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "selion/geometry/area_index.hpp"
#include "selion/motion/footprint.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// All that ways between pieces of work depend on.
struct Terrain {
  const FreeSpace& space;
  Footprint footprint;
  CurveLimits limits;
  Swings swings;  ///< within those limits
  bool may_reverse = false;
  const AreaIndex& mainland;  ///< not to be driven over where there is another way
};

constexpr double kOverMainland =
    2;  ///< extra cost of a metre over the mainland: rows just sown are not crossed
constexpr double kInReverse = 1.0;   ///< extra cost of a metre in reverse
constexpr double kGearChange_m = 6;  ///< what stopping and changing gear is worth

/// Cost of a way: its metres, those over the mainland dearer, reversing and changes of gear dearer still.
double cost_m(const Terrain& terrain, const Path& path);

/// One turn within the limits, the shortest that stays inside; absent where none of at most `most_m`, and of
/// a turn's length, does. Empty where both are one place.
std::optional<Path> direct_turn(const Terrain& terrain, const Swings& swings, const Pose& from,
                                const Pose& to, double most_m);

/// A way to one of several goals.
struct Arrival {
  std::size_t goal = 0;  ///< which of them
  Path way;
};

struct Found {
  std::size_t departure = 0;  ///< from which place
  Arrival arrival;
};
/// A way found by searching the ground itself, step by step: for narrow places. Dear; absent where none was
/// found. @pre at least one place to begin; the first says where to look.
std::optional<Found> searched(const Terrain& terrain, const std::vector<Pose>& from,
                              const std::vector<Pose>& goals);

}  // namespace selion
