// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "known_ground.hpp"
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
  const Machine& machine;
};

constexpr double kOverMainland =
    2;  ///< extra cost of a metre over the mainland: rows just sown are not crossed

/// What a stop out of `speed_mps` and back to it costs, as metres at turn speed.
double stop_m(const Machine& machine, double speed_mps);

/// Cost of a way between work ahead, in metres at turn speed: its own, more where a curve must be driven more
/// slowly, twice those of long runs backwards, three times those over the mainland, and what could be driven
/// in the time of its stops, pivots and steering while standing.
double cost_m(const Terrain& terrain, const Path& path);

/// Nothing, or straight on, where the goal lies there but for a tenth of what joints may miss: swings to mend
/// that would be crumbs. It may lead outside.
std::optional<Path> straight_on(const Pose& from, const Pose& to);

/// The shortest turn forwards of at most `longest_m` that stays inside.
std::optional<Path> turn_ahead(const Terrain& terrain, const Swings& swings, const Pose& from, const Pose& to,
                               double longest_m);

/// One turn within the limits that stays inside: the shortest one forwards or, where it takes less time, one
/// in reverse or with pivots; ground of the mainland counts as in cost_m(). Absent where none of at most
/// `most_m`, and of a turn's length, stays inside. Empty where both are one place.
std::optional<Path> direct_turn(const Terrain& terrain, const Swings& swings, const Pose& from,
                                const Pose& to, double most_m);

/// For searches, which ask for many turns and drive few: as direct_turn(), but the shortest forwards where
/// there is one, although another may take less time. Where not all is looked for, turn_with_stops() may
/// find one.
KnownTurn turn_soon_found(const Terrain& terrain, const Pose& from, const Pose& to, double most_m);
std::optional<Path> turn_with_stops(const Terrain& terrain, const Pose& from, const Pose& to, double most_m);
/// No such turn costs less.
double least_with_stop_m(const Terrain& terrain, const Pose& from, const Pose& to);

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
/// found. @pre at least one place to begin; the first says where to look. `known`: of the same terrain.
std::optional<Found> searched(const Terrain& terrain, const std::vector<Pose>& from,
                              const std::vector<Pose>& goals, KnownGround& known);

}  // namespace selion
