// SPDX-License-Identifier: GPL-3.0-or-later
#include "connect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "selion/core/angle.hpp"
#include "selion/motion/standing.hpp"
#include "selion/motion/timed_turn.hpp"

namespace selion {
namespace {

constexpr double kCostStep_m = 3;
constexpr double kShortRun = 5;    // radii: so far backwards is part of a turn
constexpr double kLongRun = 9;     // radii, or
constexpr double kLongRun_m = 20;  // where those are less: so far backwards leads no turn over the mainland
constexpr double kBackwards = 4;   // extra cost of a metre backwards beyond that: it is driven without a view

constexpr double kMiss = 1e-7;  // m, rad: a tenth of what joints may miss

/// How far `to` lies ahead, negative: behind, on the line of `from` and in its heading.
std::optional<double> ahead_in_line_m(const Pose& from, const Pose& to) {
  const Point way = to.at - from.at;
  const Point along = unit(from.heading_rad);
  const double ahead_m = dot(way, along);
  const bool in_line = std::abs(cross(along, way)) < kMiss * std::max(1.0, std::abs(ahead_m)) &&
                       std::abs(wrapped(to.heading_rad - from.heading_rad)) < kMiss;
  return in_line ? std::optional{ahead_m} : std::nullopt;
}

/// From place to place: over a metre and more the heading misses by less than places would.
Path straight(const Pose& from, const Pose& to, double ahead_m) {
  const Gear gear = ahead_m < 0 ? Gear::reverse : Gear::forward;
  if (std::abs(ahead_m) > 1) return Path{{line(from.at, to.at), gear}};
  const double heading = from.heading_rad + (gear == Gear::reverse ? std::numbers::pi : 0);
  return Path{{{from.at, heading, 0, 0, std::abs(ahead_m)}, gear}};
}

/// Straight back, where the goal lies there: swings to mend the rest would be stops for nothing.
std::optional<Path> straight_back(const Pose& from, const Pose& to) {
  const auto ahead_m = ahead_in_line_m(from, to);
  if (!ahead_m || *ahead_m > -kMiss) return std::nullopt;
  return straight(from, to, *ahead_m);
}

/// Longer than this, a single turn is no turn any more but a wander over the field.
double longest_turn_m(const Terrain& terrain, const Pose& from, const Pose& to) {
  return 20 / terrain.limits.curvature_per_m + 2 * distance_m(from.at, to.at);
}

double over_mainland_m(const Terrain& terrain, const Stretch& stretch) {
  const double length = stretch.curve.length_m;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kCostStep_m)));
  int over = 0;
  for (int i = 0; i < steps; ++i)
    if (terrain.mainland.holds(state_at(stretch.curve, length * (i + 0.5) / steps).at)) ++over;
  return length * over / steps;
}

/// The metres that take as long at turn speed where a curve has to be driven more slowly.
double slowed_m(const Machine& machine, const Stretch& stretch) {
  const Curve& curve = stretch.curve;
  const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
  const double tightest = std::max(std::abs(curve.curvature_per_m), std::abs(end));
  const double speed =
      std::min(max_speed_mps(machine, tightest, 0), max_speed_mps(machine, 0, curve.sharpness_per_m2));
  return curve.length_m * std::max(1.0, machine.turn_speed_mps / speed);
}

/// Before `stretch`, and in it.
double standing_m(const Terrain& terrain, const Stretch& last, const Stretch& stretch) {
  const Machine& machine = terrain.machine;
  double rest_s = steering_s(machine, last, stretch);
  if (is_pivot(stretch)) rest_s += pivot_s(machine, stretch.pivot_rad);
  const bool stops = stretch.gear != last.gear || is_pivot(stretch);
  return rest_s * machine.turn_speed_mps + (stops ? stop_m(machine, machine.turn_speed_mps) : 0);
}

/// The longest run backwards, without a break.
double longest_back_m(const Path& path) {
  double longest = 0;
  double run = 0;
  for (const Stretch& stretch : path) {
    run = stretch.gear == Gear::reverse ? run + stretch.curve.length_m : 0;
    longest = std::max(longest, run);
  }
  return longest;
}

/// No turn with a stop on its way takes less: what does not pivot has to drive round to the other heading.
double least_with_stop_s(const Terrain& terrain, const Pose& from, const Pose& to) {
  const Machine& machine = terrain.machine;
  const double arc_m = machine.may_pivot ? 0
                                         : std::abs(wrapped(to.heading_rad - from.heading_rad)) /
                                               terrain.limits.curvature_per_m;
  const double least_m = std::max(distance_m(from.at, to.at), arc_m);
  return (least_m + stop_m(machine, machine.turn_speed_mps)) / machine.turn_speed_mps;
}

/// The fastest turn so far, and its seconds with those more by which its ground on the mainland is dearer.
class Fastest {
 public:
  Fastest(const Terrain& terrain, double longest_m)
      : terrain_{terrain},
        longest_m_{longest_m},
        most_back_m_{std::max(kLongRun_m, kLongRun / terrain.limits.curvature_per_m)} {}

  /// Where it takes less time, however its ground on the mainland counts, and stays inside.
  void offer(const Path& turn) {
    constexpr double kNoFaster_s = 1e-6;
    if (length_m(turn) > longest_m_) return;
    const double time_s = turn_time_s(turn, terrain_.machine);
    if (time_s >= time_s_ - kNoFaster_s) return;
    const double over_s = dearer_s(turn);
    if (over_s > 0 && longest_back_m(turn) > most_back_m_) return;
    const double dear_s = time_s + over_s;
    if (dear_s >= dear_s_ - kNoFaster_s || !stays_inside(terrain_.space, terrain_.footprint, turn)) return;
    keep(turn, time_s, dear_s);
  }
  /// A turn known to stay inside.
  void begin_with(const Path& turn) {
    const double time_s = turn_time_s(turn, terrain_.machine);
    keep(turn, time_s, time_s + dearer_s(turn));
  }
  [[nodiscard]] bool beats(double time_s) const { return dear_s_ <= time_s; }
  [[nodiscard]] std::optional<Path> turn() && { return std::move(turn_); }

 private:
  [[nodiscard]] double dearer_s(const Path& turn) const {
    double over_m = 0;
    for (const Stretch& stretch : turn) over_m += over_mainland_m(terrain_, stretch);
    return kOverMainland * over_m / terrain_.machine.turn_speed_mps;
  }
  void keep(const Path& turn, double time_s, double dear_s) {
    turn_ = turn;
    time_s_ = time_s;
    dear_s_ = dear_s;
  }

  const Terrain& terrain_;
  double longest_m_;
  double most_back_m_;
  std::optional<Path> turn_;
  double time_s_ = std::numeric_limits<double>::infinity();
  double dear_s_ = std::numeric_limits<double>::infinity();
};

/// Offers all turns with stops or pivots.
std::optional<Path> fastest_with_stops(const Terrain& terrain, const Swings& swings, const Pose& from,
                                       const Pose& to, Fastest fastest) {
  const Manoeuvres may = manoeuvres_of(terrain.machine);
  for (const TurnKind& kind : turns())
    if (kind.needs != Needs::nothing && allows(may, kind.needs))
      for (const Path& turn : kind.candidates(from, to, swings)) fastest.offer(turn);
  return std::move(fastest).turn();
}

/// Ahead or behind, where the goal lies so.
struct OnLine {
  bool is_decided = false;  ///< no other turn need be looked for
  std::optional<Path> way;
};

OnLine on_line(const Terrain& terrain, const Pose& from, const Pose& to) {
  if (auto straight = straight_on(from, to))
    return {true,
            stays_inside(terrain.space, terrain.footprint, *straight) ? std::move(straight) : std::nullopt};
  auto back = terrain.may_reverse ? straight_back(from, to) : std::nullopt;
  if (back && stays_inside(terrain.space, terrain.footprint, *back)) return {true, std::move(back)};
  return {};
}

}  // namespace

double stop_m(const Machine& machine, double speed_mps) {
  const double lost_s = speed_mps / 2 * (1 / machine.max_accel_mps2 + 1 / machine.max_brake_mps2);
  return lost_s * machine.turn_speed_mps;
}

double cost_m(const Terrain& terrain, const Path& path) {
  const double short_run_m = kShortRun / terrain.limits.curvature_per_m;
  double cost = 0;
  double backwards_m = 0;  // without a break
  const Stretch* last = nullptr;
  for (const Stretch& stretch : path) {
    cost += slowed_m(terrain.machine, stretch) + kOverMainland * over_mainland_m(terrain, stretch);
    if (last != nullptr) cost += standing_m(terrain, *last, stretch);
    const double before_m = backwards_m;
    backwards_m = stretch.gear == Gear::reverse ? backwards_m + stretch.curve.length_m : 0;
    cost += kBackwards * std::max(0.0, backwards_m - std::max(before_m, short_run_m));
    last = &stretch;
  }
  if (last == nullptr) return 0;
  const double stop = stop_m(terrain.machine, terrain.machine.work_speed_mps);
  if (path.front().gear == Gear::reverse) cost += stop;
  if (path.back().gear == Gear::reverse) cost += stop;
  return cost;
}

std::optional<Path> straight_on(const Pose& from, const Pose& to) {
  const auto ahead_m = ahead_in_line_m(from, to);
  if (!ahead_m || *ahead_m < -kMiss) return std::nullopt;
  if (*ahead_m < kMiss) return Path{};
  return straight(from, to, *ahead_m);
}

std::optional<Path> turn_ahead(const Terrain& terrain, const Swings& swings, const Pose& from, const Pose& to,
                               double longest_m) {
  Connections turns{from, to, swings};
  while (auto turn = turns.next(longest_m))
    if (stays_inside(terrain.space, terrain.footprint, *turn)) return turn;
  return std::nullopt;
}

std::optional<Path> direct_turn(const Terrain& terrain, const Swings& swings, const Pose& from,
                                const Pose& to, double most_m) {
  if (auto line = on_line(terrain, from, to); line.is_decided) return std::move(line.way);
  const double longest = std::min(most_m, longest_turn_m(terrain, from, to));
  auto ahead = turn_ahead(terrain, swings, from, to, longest);
  if (manoeuvres_of(terrain.machine) == Manoeuvres{}) return ahead;
  Fastest fastest{terrain, longest};
  if (ahead) fastest.begin_with(*ahead);
  if (fastest.beats(least_with_stop_s(terrain, from, to))) return ahead;
  return fastest_with_stops(terrain, swings, from, to, std::move(fastest));
}

KnownTurn turn_soon_found(const Terrain& terrain, const Pose& from, const Pose& to, double most_m) {
  if (auto line = on_line(terrain, from, to); line.is_decided) return {std::move(line.way), true};
  const double longest = std::min(most_m, longest_turn_m(terrain, from, to));
  auto ahead = turn_ahead(terrain, terrain.swings, from, to, longest);
  const bool is_all = ahead || manoeuvres_of(terrain.machine) == Manoeuvres{};
  return {std::move(ahead), is_all};
}

std::optional<Path> turn_with_stops(const Terrain& terrain, const Pose& from, const Pose& to, double most_m) {
  const double longest = std::min(most_m, longest_turn_m(terrain, from, to));
  return fastest_with_stops(terrain, terrain.swings, from, to, Fastest{terrain, longest});
}

double least_with_stop_m(const Terrain& terrain, const Pose& from, const Pose& to) {
  return least_with_stop_s(terrain, from, to) * terrain.machine.turn_speed_mps;
}

}  // namespace selion
