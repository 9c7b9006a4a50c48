// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/timed_turn.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "selion/motion/standing.hpp"
#include "selion/motion/turns.hpp"

namespace selion {
namespace {

constexpr double kNextSpeed = 0.75;
constexpr double kLeastClothoid = 0.1;  // of the tightest radius
constexpr std::size_t kMostSpeeds = 10;
constexpr double kSlightlySlower = 0.9;
constexpr int kNoFasterInVain = 3;  // speeds tried after the best: the shape of the turn changes among them

/// Straights before and after the turn, so long that it may begin and end at rest.
struct Leads {
  double before_m = 0;
  double after_m = 0;
  double time_s = 0;  ///< of both at work speed
};

Leads leads_of(const Machine& machine) {
  const double speed = machine.work_speed_mps;
  const double before = speed * speed / 2 / machine.max_brake_mps2;
  const double after = speed * speed / 2 / machine.max_accel_mps2;
  return {before, after, (before + after) / speed};
}

void add_turn(std::vector<Leg>& legs, const Path& turn, const Machine& machine) {
  const Stretch* last = nullptr;
  for (const Stretch& stretch : turn) {
    if (last != nullptr)
      if (const double wait_s = steering_s(machine, *last, stretch); wait_s > 0)
        legs.push_back({standing_after(*last), 0, false, wait_s});
    const double rest_s = is_pivot(stretch) ? pivot_s(machine, stretch.pivot_rad) : 0;
    legs.push_back({stretch, turn_cap_mps(machine, stretch.curve), false, rest_s});
    last = &stretch;
  }
}

/// The legs of `legs` are overwritten: a buffer for many turns. Speeds do not hang on places.
double time_s(const Path& turn, const Machine& machine, const Leads& leads, std::vector<Leg>& legs) {
  legs.clear();
  legs.push_back({{{{}, 0, 0, 0, leads.before_m}}, machine.work_speed_mps, true, 0});
  add_turn(legs, turn, machine);
  legs.push_back({{{{}, 0, 0, 0, leads.after_m}}, machine.work_speed_mps, true, 0});
  const EndSpeeds work{machine.work_speed_mps, machine.work_speed_mps};
  return duration_s(legs, machine, work) - leads.time_s;
}

}  // namespace

double turn_cap_mps(const Machine& machine, const Curve& curve) {
  const bool bends = curve.curvature_per_m != 0 || curve.sharpness_per_m2 != 0;
  return bends ? machine.turn_speed_mps : machine.max_speed_mps;
}

std::vector<Leg> turn_legs(const Path& turn, const Machine& machine) {
  std::vector<Leg> legs;
  legs.reserve(turn.size());
  add_turn(legs, turn, machine);
  return legs;
}

double turn_time_s(const Path& turn, const Machine& machine) {
  std::vector<Leg> legs;
  return time_s(turn, machine, leads_of(machine), legs);
}

std::vector<double> turn_speeds(const Machine& machine) {
  const double curvature = max_curvature_per_m(machine);
  std::vector<double> speeds{machine.turn_speed_mps};
  while (speeds.size() < kMostSpeeds) {
    const double next = kNextSpeed * speeds.back();
    if (curvature * curvature < kLeastClothoid * max_sharpness_per_m2(machine, next)) break;
    speeds.push_back(next);
  }
  return speeds;
}

double swath_turn_speed_mps(const Machine& machine, double spacing_m) {
  const auto time_at_s = [&](double speed_mps) {
    const Swings swings{limits_at(machine, speed_mps)};
    const auto turn = Connections{{{0, 0}, 0}, {{0, spacing_m}, std::numbers::pi}, swings}.next();
    return turn ? turn_time_s(*turn, machine) : std::numeric_limits<double>::infinity();
  };
  double best_mps = machine.turn_speed_mps;
  double best_s = time_at_s(best_mps);
  double speed_mps = best_mps;
  for (int in_vain = 0; in_vain < kNoFasterInVain; ++in_vain) {
    speed_mps *= kSlightlySlower;
    const double time_s = time_at_s(speed_mps);
    if (time_s >= best_s) continue;
    best_s = time_s;
    best_mps = speed_mps;
    in_vain = -1;
  }
  return best_mps;
}

std::optional<TimedTurn> fastest_turn(const Pose& from, const Pose& to, const Machine& machine,
                                      std::span<const double> speeds_mps, const Inside& inside) {
  const Leads leads = leads_of(machine);
  std::vector<Leg> legs;
  std::optional<TimedTurn> best;
  for (const double speed : speeds_mps) {
    for (Path& path : connections(from, to, limits_at(machine, speed))) {
      if (best && length_m(path) >= best->time_s * machine.max_speed_mps)
        break;  // nor is a longer one faster
      const double time = time_s(path, machine, leads, legs);
      if ((best && time >= best->time_s) || !inside(path)) continue;
      best = TimedTurn{std::move(path), speed, time};
    }
  }
  return best;
}

}  // namespace selion
