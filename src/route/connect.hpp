// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "selion/geometry/boolean.hpp"
#include "selion/motion/footprint.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// A headland pass as a road: the axle's closed path and the places where it runs straight, where one can join or leave.
struct Track {
  Path path;
  double length_m = 0;
  struct Station {
    double s_m = 0;
    Pose pose;
  };
  std::vector<Station> stations;   ///< in order of s
};

/// A closed path as a track, in the direction it is given.
Track track_of(const Path& closed);
/// The closed path driven forwards the other way round.
Path turned_round(const Path& closed);
/// The part of a closed path from `from_m` to `to_m` along it, across its seam where to < from or beyond the path's length.
Path part_of(const Path& closed, double from_m, double to_m);

/// All that ways between pieces of work depend on.
struct Terrain {
  const FreeSpace& space;
  Footprint footprint;
  CurveLimits limits;
  bool may_reverse = false;
  const Polygons& mainland;          ///< not to be driven over where there is another way
  std::vector<Track> tracks;         ///< each headland pass in both directions where the machine fits
};

/// Cost of a way: its metres, those over the mainland dearer, reversing and changes of gear dearer still.
double cost_m(const Terrain& terrain, const Path& path);

/// A drivable way from rest-free pose to pose, curvature 0 at both ends, inside all along; absent where none was found.
std::optional<Path> connect(const Terrain& terrain, const Pose& from, const Pose& to);
/// Only the short answer: one turn, without tracks and without search.
std::optional<Path> direct_turn(const Terrain& terrain, const Pose& from, const Pose& to);

/// The families of methods behind connect(), cheapest first.
std::optional<Path> along_tracks(const Terrain& terrain, const Pose& from, const Pose& to);
std::optional<Path> searched(const Terrain& terrain, const Pose& from, const Pose& to);

}  // namespace selion
