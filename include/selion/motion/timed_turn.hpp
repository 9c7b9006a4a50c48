// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/motion/path.hpp"
#include "selion/motion/speed.hpp"

namespace selion {

/// Cap of a stretch between two pieces of work: turn_speed_mps where it bends, max_speed_mps where it is
/// straight.
double turn_cap_mps(const Machine& machine, const Curve& curve);

/// The turn as legs with these caps, tool up: with the time of its pivots, and a wait wherever the wheels are
/// steered while the machine stands.
std::vector<Leg> turn_legs(const Path& turn, const Machine& machine);

/// Seconds that the turn costs between two pieces of work: driving it, and what braking for it and gaining
/// speed after it lose against work_speed_mps. That speed is left and regained on the straight.
double turn_time_s(const Path& turn, const Machine& machine);

/// The speeds worth planning a turn for, fastest first: turn_speed_mps, then each a quarter lower, as long as
/// the clothoid onto the tightest arc is longer than a tenth of its radius. A lower speed makes clothoids
/// sharper (Cariou et al. 2020, eq. 20), hence the turn shorter, but below a tenth of the radius what is left
/// to gain is less than that a curve, and what is lost to braking grows. One to ten.
std::vector<double> turn_speeds(const Machine& machine);

/// The speed, turn_speed_mps or lower, for which the shortest turn between swaths `spacing_m` apart is the
/// fastest: with slow steering, turns for the highest speed are so long that slower ones take less time.
/// Within a tenth.
double swath_turn_speed_mps(const Machine& machine, double spacing_m);

struct TimedTurn {
  Path path;
  double planned_mps =
      0;              ///< the speed whose sharpness it keeps; it may be driven faster where it bends most
  double time_s = 0;  ///< turn_time_s()
};

using Inside = std::function<bool(const Path&)>;

/// Of the candidates of connections() for each of `speeds_mps` the one of least turn_time_s() that stays
/// inside; absent where none does. `inside` is asked only about turns that would be the fastest so far.
/// @pre the speeds are at most turn_speed_mps.
std::optional<TimedTurn> fastest_turn(const Pose& from, const Pose& to, const Machine& machine,
                                      std::span<const double> speeds_mps, const Inside& inside);

}  // namespace selion
