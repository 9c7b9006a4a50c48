// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "roads.hpp"

namespace selion {
namespace {

constexpr double kStationStep_m = 3;

Curve part_of(const Curve& curve, double from_m, double to_m) {
  const CurveState at = state_at(curve, from_m);
  return {at.at, at.heading_rad, at.curvature_per_m, curve.sharpness_per_m2, to_m - from_m};
}

int station_count(double straight_m) {
  return std::max(1, static_cast<int>(std::ceil(straight_m / kStationStep_m)));
}

/// Of the stations on one straight: the ones at its ends, and a few between.
bool is_junction(int station, int count) {
  constexpr int kAtEnd = 2;
  constexpr int kEvery = 8;
  return station < kAtEnd || station >= count - kAtEnd || station % kEvery == 0;
}

}  // namespace

Path part_of(const Path& path, double from_m, double to_m) {
  constexpr double kNothing_m = 1e-9;
  Path part;
  double left = to_m >= from_m ? to_m - from_m : to_m - from_m + length_m(path);
  double skip = from_m;
  for (std::size_t i = 0; left > kNothing_m && i < 2 * path.size() + 1; ++i) {
    const Stretch& stretch = path[i % path.size()];
    const double length = stretch.curve.length_m;
    if (skip >= length) {
      skip -= length;
      continue;
    }
    const double to = std::min(length, skip + left);
    if (to - skip > kNothing_m) part.push_back({part_of(stretch.curve, skip, to), stretch.gear});
    left -= to - skip;
    skip = 0;
  }
  return part;
}

/// A straight way on from the path's end, as far as the machine fits.
Path run_on(const Terrain& terrain, const Pose& from) {
  constexpr double kFarthest_m = 20;
  constexpr double kStep_m = 0.5;
  double far_m = 0;
  while (far_m < kFarthest_m &&
         fits(terrain.space, terrain.footprint,
              {from.at + (far_m + kStep_m) * unit(from.heading_rad), from.heading_rad}))
    far_m += kStep_m;
  if (far_m == 0) return {};
  return {{line(from.at, from.at + far_m * unit(from.heading_rad)), Gear::forward}};
}

Track track_joined_at_ends(const Path& line, double end_m) {
  Track track{line, false, length_m(line), {}};
  const int steps = station_count(track.length_m);
  for (int i = 0; i < steps; ++i) {
    const double s = track.length_m * (i + 0.5) / steps;
    if (s > end_m && s < track.length_m - end_m) continue;
    track.stations.push_back({s, vehicle_pose(line.front(), s), true});
  }
  track.stations.push_back({track.length_m, end_pose(line), true});
  return track;
}

Track track_of(const Path& path, bool closed) {
  Track track{path, closed, length_m(path), {}};
  double before = 0;
  for (const Stretch& stretch : path) {
    const double length = stretch.curve.length_m;
    const int steps = station_count(length);
    for (int i = 0; is_straight(stretch.curve) && i < steps; ++i) {
      const double s = length * (i + 0.5) / steps;
      track.stations.push_back({before + s, vehicle_pose(stretch, s), is_junction(i, steps)});
    }
    before += length;
  }
  if (!closed && !path.empty()) track.stations.push_back({track.length_m, end_pose(path), true});
  return track;
}

}  // namespace selion
