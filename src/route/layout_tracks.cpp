// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "roads.hpp"
#include "selion/layout/layout.hpp"
#include "task.hpp"

namespace selion {
namespace {

constexpr double kSwathEnd_m = 4;  // of a swath: where it is joined as a road

bool near_box(const Box& box, Point p, double near_m) {
  return p.x_m > box.low.x_m - near_m && p.x_m < box.high.x_m + near_m && p.y_m > box.low.y_m - near_m &&
         p.y_m < box.high.y_m + near_m;
}

/// Swaths serve as roads to and from obstacles inside: they are joined at their ends and beside those only.
Track swath_track(const std::vector<Box>& holes, const Path& way, double near_m) {
  if (holes.empty()) return track_joined_at_ends(way, kSwathEnd_m);
  Track track = track_of(way, false);
  const auto beside_hole = [&](const Track::Station& station) {
    return std::any_of(holes.begin(), holes.end(),
                       [&](const Box& hole) { return near_box(hole, station.pose.at, near_m); });
  };
  const double length = track.length_m;
  std::erase_if(track.stations, [&](const Track::Station& station) {
    return station.s_m > kSwathEnd_m && station.s_m < length - kSwathEnd_m && !beside_hole(station);
  });
  return track;
}

/// The pocket piece, run on straight beyond both of its ends.
Path pocket_way(const Terrain& terrain, const Machine& machine, const Swath& pocket) {
  Path way = turned_round(swath_way(machine, pocket, Sense::forth));
  append(way, run_on(terrain, end_pose(way)));
  way = turned_round(way);
  append(way, run_on(terrain, end_pose(way)));
  return way;
}

void add_both_ways(std::vector<Track>& tracks, const Path& path, bool closed, bool either_way) {
  tracks.push_back(track_of(path, closed));
  if (either_way) tracks.push_back(track_of(turned_round(path), closed));
}

std::vector<Box> boxes_around_holes(const Terrain& terrain) {
  std::vector<Box> boxes;
  for (const Ring& hole : terrain.space.area().holes) boxes.push_back(bounds(hole));
  return boxes;
}

/// Of lines side by side, closer together than a turn from one to the next is wide, only so many lead
/// elsewhere than their neighbours.
int lines_apart(const Machine& machine, const Terrain& terrain) {
  return std::max(1, static_cast<int>(2 / terrain.limits.curvature_per_m / machine.working_width_m));
}

}  // namespace

std::vector<Track> tracks_of(const Layout& layout, const Machine& machine, const Terrain& terrain) {
  const int apart = lines_apart(machine, terrain);
  std::vector<Track> tracks;
  for (const HeadlandPass& pass : layout.headland_passes)
    if (!pass.closed || pass.ring == 1 || (layout.passes - pass.ring) % apart == 0)
      add_both_ways(tracks, pass.path, pass.closed, pass.either_way);
  for (const Swath& pocket : layout.pockets)
    if (const Path way = pocket_way(terrain, machine, pocket); fits(terrain.space, terrain.footprint, way))
      add_both_ways(tracks, way, false, fits(terrain.space, terrain.footprint, turned_round(way)));
  const double near_m = layout.headland_depth_m + 6 / terrain.limits.curvature_per_m;
  const std::vector<Box> holes = boxes_around_holes(terrain);
  for (const Swath& swath : layout.swaths) {
    if (swath.strip % apart != 0) continue;
    for (const Sense sense : {Sense::forth, Sense::back})
      if (const Path way = swath_way(machine, swath, sense); fits(terrain.space, terrain.footprint, way))
        tracks.push_back(swath_track(holes, way, near_m));
  }
  return tracks;
}

}  // namespace selion
