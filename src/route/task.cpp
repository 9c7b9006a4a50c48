// SPDX-License-Identifier: GPL-3.0-or-later
#include "task.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "roads.hpp"
#include "selion/motion/dead_ends.hpp"

namespace selion {
namespace {

constexpr std::ptrdiff_t kDenseStarts = 6;  // stations either way of which each is tried to begin a headland pass
constexpr double kLeastSplit = 8;  // working widths of length from which an open headland pass may be split

/// The path from its first straight place at or beyond `from_m`: a swath may only be begun where the wheels
/// stand straight.
Path from_straight(const Path& path, double from_m) {
  double begin_m = 0;
  for (const Stretch& stretch : path) {
    const bool straight = stretch.curve.curvature_per_m == 0 && stretch.curve.sharpness_per_m2 == 0;
    const double end_m = begin_m + stretch.curve.length_m;
    if (straight && end_m > from_m) return part_of(path, std::max(begin_m, from_m), length_m(path));
    begin_m = end_m;
  }
  return path;
}

/// The same ground worked the other way: the axle's path is moved on by the tool's place at either end.
Path tool_turned_round(const Path& path, double tool_x_m) {
  Path back = turned_round(path);
  const double shift_m = -2 * tool_x_m;  // from leading the tool at one end to leading it at the other
  const Pose end = end_pose(back);
  if (shift_m > 0) append(back, {{line(end.at, end.at + shift_m * unit(end.heading_rad)), Gear::forward}});
  if (shift_m <= 0 || length_m(back) < 2 * shift_m) return back;
  return from_straight(back, shift_m);
}

/// The round begun at stations to either side of the one nearest to `here`, the further off the fewer: the near
/// ones may be hard to reach, and a wide lane change takes many metres.
std::vector<Path> begun_around(const Path& round, const std::optional<Pose>& here) {
  const Track track = track_of(round, true);
  const auto& stations = track.stations;
  if (stations.empty()) return {};
  const auto nearest = std::min_element(stations.begin(), stations.end(),
                                        [&here](const Track::Station& a, const Track::Station& b) {
                                          return far_m(here, a.pose) < far_m(here, b.pose);
                                        });
  const auto count = static_cast<std::ptrdiff_t>(stations.size());
  const std::ptrdiff_t middle = nearest - stations.begin();
  std::vector<Path> ways;
  const auto begin_at = [&](std::ptrdiff_t station) {
    const double s_m = stations[static_cast<std::size_t>((station + count) % count)].s_m;
    ways.push_back(part_of(round, s_m, s_m + track.length_m));
  };
  begin_at(middle);
  std::ptrdiff_t off = 1;
  for (; 2 * off < count; off += 1 + off / kDenseStarts) {
    begin_at(middle + off);
    begin_at(middle - off);
  }
  return ways;
}

/// May the machine drive the way without ending where it cannot leave? One that may reverse backs out.
bool passable(const Terrain& terrain, const Path& way) {
  return terrain.may_reverse ||
         (has_way_in(terrain.space, terrain.footprint, terrain.limits, start_pose(way)) &&
          has_way_out(terrain.space, terrain.footprint, terrain.limits, end_pose(way)));
}

}  // namespace

Sense opposite(Sense sense) { return sense == Sense::forth ? Sense::back : Sense::forth; }

Path swath_way(const Machine& machine, const Swath& swath, Sense sense) {
  return sense == Sense::forth ? swath_path(machine, swath.from, swath.to)
                               : swath_path(machine, swath.to, swath.from);
}

Task swath_task(const Terrain& terrain, const Machine& machine, const Swath& swath, Sense preferred) {
  Task task{PieceKind::swath, swath.id, {}};
  for (const Sense sense : {preferred, opposite(preferred)})
    if (Path way = swath_way(machine, swath, sense);
        fits(terrain.space, terrain.footprint, way) && passable(terrain, way))
      task.ways.push_back(std::move(way));
  return task;
}

Task open_pass_task(const Terrain& terrain, const Machine& machine, std::string id, const Path& path) {
  Task task{PieceKind::headland_pass, std::move(id), {}};
  for (const Path& way : {path, tool_turned_round(path, machine.tool_x_m)})
    if (fits(terrain.space, terrain.footprint, way) && passable(terrain, way)) task.ways.push_back(way);
  return task;
}

Task closed_pass_task(const Terrain& terrain, const HeadlandPass& pass, const std::optional<Pose>& here,
                      Round round) {
  Task task{PieceKind::headland_pass, pass.id, {}, true};
  const Path path = round == Round::as_laid ? pass.path : turned_round(pass.path);
  if (round == Round::turned && !fits(terrain.space, terrain.footprint, path)) return task;
  task.ways = begun_around(path, here);
  sort_nearest_first(task.ways, here);
  return task;
}

void add_ways(Task& task, Task others, const std::optional<Pose>& here) {
  task.ways.insert(task.ways.end(), std::make_move_iterator(others.ways.begin()),
                   std::make_move_iterator(others.ways.end()));
  sort_nearest_first(task.ways, here);
}

std::optional<double> split_place_m(const Task& task, double working_width_m) {
  if (task.kind != PieceKind::headland_pass || task.closed || task.ways.empty()) return std::nullopt;
  const Track track = track_of(task.ways.front(), false);
  if (track.length_m < kLeastSplit * working_width_m) return std::nullopt;
  const auto off_middle_m = [half_m = track.length_m / 2](const Track::Station& station) {
    return std::abs(station.s_m - half_m);
  };
  const auto middle = std::min_element(
      track.stations.begin(), track.stations.end(),
      [&](const Track::Station& a, const Track::Station& b) { return off_middle_m(a) < off_middle_m(b); });
  if (middle == track.stations.end()) return std::nullopt;
  if (middle->s_m < track.length_m / 4 || middle->s_m > 3 * track.length_m / 4) return std::nullopt;
  return middle->s_m;
}

double far_m(const std::optional<Pose>& here, const Pose& pose) {
  return here ? distance_m(here->at, pose.at) : 0;
}

void sort_nearest_first(std::vector<Path>& ways, const std::optional<Pose>& here) {
  std::stable_sort(ways.begin(), ways.end(), [&here](const Path& a, const Path& b) {
    return far_m(here, start_pose(a)) < far_m(here, start_pose(b));
  });
}

}  // namespace selion
