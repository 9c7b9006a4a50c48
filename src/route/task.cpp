// SPDX-License-Identifier: GPL-3.0-or-later
#include "task.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "roads.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/dead_ends.hpp"

namespace selion {
namespace {

constexpr std::ptrdiff_t kDenseStarts =
    6;                             // stations either way of which each is tried to begin a headland pass
constexpr double kLeastSplit = 8;  // working widths of length from which an open headland pass may be split

/// The path from its first straight place at or beyond `from_m`: a swath may only be begun where the wheels
/// stand straight.
Path from_straight(const Path& path, double from_m) {
  double begin_m = 0;
  for (const Stretch& stretch : path) {
    const double end_m = begin_m + stretch.curve.length_m;
    if (is_straight(stretch.curve) && end_m > from_m)
      return part_of(path, std::max(begin_m, from_m), length_m(path));
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

/// How much of the straight on which the machine stands at `station` lies ahead.
double straight_ahead_m(const Track& track, std::size_t station) {
  const auto& stations = track.stations;
  const std::size_t count = stations.size();
  double ahead_m = 0;
  for (std::size_t k = station; k < station + count; ++k) {
    const auto& here = stations[k % count];
    const auto& next = stations[(k + 1) % count];
    if (std::abs(wrapped(next.pose.heading_rad - here.pose.heading_rad)) > 1e-6) break;
    ahead_m += distance_m(here.pose.at, next.pose.at);
  }
  return ahead_m;
}

double nearest_m(const std::vector<Point>& places, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point place : places) least = std::min(least, distance_m(place, p));
  return least;
}

/// Begun at stations to either side of the one nearest to `here`, the further off the fewer: the near ones
/// may be hard to reach, and a wide lane change takes many metres.
void begin_around(Task& task, const std::optional<Pose>& here, const std::vector<Point>& then_to,
                  double lane_change_m) {
  const std::size_t line = task.lines.size() - 1;
  const Track track = track_of(task.lines.back(), true);
  const auto& stations = track.stations;
  if (stations.empty()) return;
  const auto nearest = std::min_element(stations.begin(), stations.end(),
                                        [&here](const Track::Station& a, const Track::Station& b) {
                                          return far_m(here, a.pose) < far_m(here, b.pose);
                                        });
  const auto count = static_cast<std::ptrdiff_t>(stations.size());
  const std::ptrdiff_t middle = nearest - stations.begin();
  const auto begin_at = [&](std::ptrdiff_t offset) {
    const auto at = static_cast<std::size_t>((middle + offset + count) % count);
    const double rest_m = then_to.empty() ? std::max(0.0, lane_change_m - straight_ahead_m(track, at))
                                          : nearest_m(then_to, stations[at].pose.at);
    task.ways.push_back({line, stations[at].s_m, stations[at].pose, rest_m});
  };
  begin_at(0);
  for (std::ptrdiff_t off = 1; 2 * off < count; off += 1 + off / kDenseStarts) {
    begin_at(off);
    begin_at(-off);
  }
}

/// May the machine drive the way without ending where it cannot leave? One that may reverse backs out.
bool passable(const Terrain& terrain, const Path& way) {
  return terrain.may_reverse ||
         (has_way_in(terrain.space, terrain.footprint, terrain.swings, start_pose(way)) &&
          has_way_out(terrain.space, terrain.footprint, terrain.swings, end_pose(way)));
}

bool has_way_in(const Terrain& terrain, const Pose& pose) {
  return has_way_in(terrain.space, terrain.footprint, terrain.swings, pose);
}

bool has_way_out(const Terrain& terrain, const Pose& pose) {
  return has_way_out(terrain.space, terrain.footprint, terrain.swings, pose);
}

/// From the first straight place into which the machine comes to the last out of which it goes on: the rest
/// lies in corners where it would be stuck. Empty where there are no such places.
Path without_dead_ends(const Terrain& terrain, const Path& way) {
  const auto& stations = track_of(way, false).stations;
  const auto first = std::find_if(stations.begin(), stations.end(), [&](const Track::Station& station) {
    return has_way_in(terrain, station.pose);
  });
  const auto last = std::find_if(stations.rbegin(), stations.rend(), [&](const Track::Station& station) {
    return has_way_out(terrain, station.pose);
  });
  if (first == stations.end() || last == stations.rend() || last->s_m <= first->s_m) return {};
  const double from_m = has_way_in(terrain, start_pose(way)) ? 0 : first->s_m;
  return part_of(way, from_m, last->s_m);
}

}  // namespace

Sense opposite(Sense sense) { return sense == Sense::forth ? Sense::back : Sense::forth; }

Path swath_way(const Machine& machine, const Swath& swath, Sense sense) {
  return sense == Sense::forth ? swath_path(machine, swath.from, swath.to)
                               : swath_path(machine, swath.to, swath.from);
}

void Task::add_line(Path line) {
  ways.push_back({lines.size(), 0, start_pose(line), 0});
  lines.push_back(std::move(line));
}

Path path_of(const Task& task, const Way& way) {
  const Path& line = task.lines[way.line];
  return task.closed ? part_of(line, way.from_m, way.from_m + length_m(line)) : line;
}

Task swath_task(const Terrain& terrain, const Machine& machine, const Swath& swath,
                std::initializer_list<Sense> senses) {
  Task task{PieceKind::swath, swath.id, {}, {}};
  for (const Sense sense : senses)
    if (Path way = swath_way(machine, swath, sense);
        fits(terrain.space, terrain.footprint, way) && passable(terrain, way))
      task.add_line(std::move(way));
  return task;
}

Task open_pass_task(const Terrain& terrain, const Machine& machine, std::string id, const Path& path) {
  Task task{PieceKind::headland_pass, std::move(id), {}, {}};
  std::vector<Path> ways{path, tool_turned_round(path, machine.tool_x_m)};
  std::erase_if(ways, [&](const Path& way) { return !fits(terrain.space, terrain.footprint, way); });
  for (const Path& way : ways)
    if (passable(terrain, way)) task.add_line(way);
  if (!task.lines.empty()) return task;
  for (const Path& way : ways)
    if (Path part = without_dead_ends(terrain, way); length_m(part) >= machine.working_width_m)
      task.add_line(std::move(part));
  return task;
}

Task closed_pass_task(const Terrain& terrain, const HeadlandPass& pass, const std::optional<Pose>& here,
                      Round round, const std::vector<Point>& then_to) {
  constexpr double kLaneChange = 12;  // turning radii: onto a ring at the border it is a wide one
  Task task{PieceKind::headland_pass, pass.id, {}, {}, true};
  Path line = round == Round::as_laid ? pass.path : turned_round(pass.path);
  if (round == Round::turned && !pass.either_way) return task;
  task.lines.push_back(std::move(line));
  begin_around(task, here, then_to, kLaneChange / terrain.limits.curvature_per_m);
  sort_nearest_first(task.ways, here);
  return task;
}

void add_ways(Task& task, Task others, const std::optional<Pose>& here) {
  for (Way& way : others.ways) way.line += task.lines.size();
  task.lines.insert(task.lines.end(), std::make_move_iterator(others.lines.begin()),
                    std::make_move_iterator(others.lines.end()));
  task.ways.insert(task.ways.end(), others.ways.begin(), others.ways.end());
  sort_nearest_first(task.ways, here);
}

std::optional<double> split_place_m(const Task& task, double working_width_m) {
  if (task.kind != PieceKind::headland_pass || task.closed || task.ways.empty()) return std::nullopt;
  const Track track = track_of(task.lines.front(), false);
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

void sort_nearest_first(std::vector<Way>& ways, const std::optional<Pose>& here) {
  std::stable_sort(ways.begin(), ways.end(), [&here](const Way& a, const Way& b) {
    return far_m(here, a.start) < far_m(here, b.start);
  });
}

}  // namespace selion
