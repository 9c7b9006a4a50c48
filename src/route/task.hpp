// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "connect.hpp"
#include "selion/core/machine.hpp"
#include "selion/layout/layout.hpp"
#include "selion/route/route.hpp"

namespace selion {

/// One way to drive a piece of work.
struct Way {
  std::size_t line = 0;  ///< of the task's lines
  double from_m = 0;     ///< where along it a closed pass is begun
  Pose start;
  double rest_m = 0;  ///< what follows costs so much more than after the best way
};

/// A piece of work and the ways it may be driven, the preferred one first.
struct Task {
  PieceKind kind = PieceKind::swath;
  std::string id;
  std::vector<Path> lines;
  std::vector<Way> ways;
  bool closed = false;  ///< a headland pass all around

  void add_line(Path line);  ///< driven from its start to its end
};

Path path_of(const Task& task, const Way& way);

enum class Sense { forth, back };  ///< from a swath's A side to its B side, or the other way

Sense opposite(Sense sense);
Path swath_way(const Machine& machine, const Swath& swath, Sense sense);

/// A swath or pocket piece driven in one of `senses`, the first one preferred; those in which the machine
/// fits.
Task swath_task(const Terrain& terrain, const Machine& machine, const Swath& swath,
                std::initializer_list<Sense> senses);

/// A part of the way round: either way along it.
Task open_pass_task(const Terrain& terrain, const Machine& machine, std::string id, const Path& path);

enum class Round { as_laid, turned };  ///< which way a closed pass is driven round

/// A closed pass begun at stations all around; from `here` the nearest first. It ends where it began:
/// `then_to` are the places of which the machine goes to the nearest next; if there are none, to the next
/// ring, for which it changes lanes on a straight. No ways where the machine does not fit.
Task closed_pass_task(const Terrain& terrain, const HeadlandPass& pass, const std::optional<Pose>& here,
                      Round round, const std::vector<Point>& then_to);
/// Puts the ways of another task for the same piece beside those of `task`.
void add_ways(Task& task, Task others, const std::optional<Pose>& here);

/// Where along its first way a long open pass may be cut into two; absent where it may not.
std::optional<double> split_place_m(const Task& task, double working_width_m);

/// As the crow flies; 0 where the machine does not stand anywhere yet.
double far_m(const std::optional<Pose>& here, const Pose& pose);
void sort_nearest_first(std::vector<Way>& ways, const std::optional<Pose>& here);

}  // namespace selion
