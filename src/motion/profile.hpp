// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "speed_limit.hpp"

namespace selion {

/// The fastest profile below what is allowed: the parts of all legs with the speeds at their ends.
struct Profile {
  std::vector<SpeedPart> parts;
  double accel_mps2 = 0;
  double brake_mps2 = 0;
};
Profile profile_of(std::span<const Leg> legs, const Machine& machine, const EndSpeeds& ends);

/// A corner of the profile: the square of the speed is linear in between.
struct Knot {
  double s_m = 0;
  double speed2 = 0;
  double speed_mps = 0;
};

inline double seconds(const Knot& from, const Knot& to) {
  return 2 * (to.s_m - from.s_m) / (from.speed_mps + to.speed_mps);
}

/// Hands the runs of one leg to `run(leg, from, to)`, without the corners that it can do without.
template <class Run>
class Runs {
 public:
  Runs(std::size_t leg, const Knot& start, Run& run) : leg_{leg}, last_{start}, run_{run} {}

  void add(const Knot& next) {
    if (holds_ && needed(held_, next)) {
      run_(leg_, last_, held_);
      last_ = held_;
    }
    held_ = next;
    holds_ = true;
  }
  void end() {
    if (holds_) run_(leg_, last_, held_);
  }

 private:
  /// Corners that point down touch a limit from below and stay. Of others the chord beside them is slower and
  /// its slope between theirs: they go where they are collinear or too near to another.
  [[nodiscard]] bool needed(const Knot& corner, const Knot& next) const {
    constexpr double kLeastCorner_s = 5e-4;
    constexpr double kCollinear = 1e-12;
    if (last_.speed2 == 0 && next.speed2 == 0) return true;
    const double way_m = next.s_m - last_.s_m;
    const double above =
        (corner.speed2 - last_.speed2) * way_m - (next.speed2 - last_.speed2) * (corner.s_m - last_.s_m);
    const double rounding = kCollinear * corner.speed2 * way_m;
    if (above < -rounding) return true;
    return above > rounding && seconds(last_, corner) >= kLeastCorner_s &&
           seconds(corner, next) >= kLeastCorner_s;
  }

  std::size_t leg_;
  Knot last_;
  Knot held_;  // not an optional: GCC 12 takes its contents for uninitialised
  bool holds_ = false;
  Run& run_;
};

/// Where a part's profile leaves the acceleration from its start and where it begins to brake for its end: at
/// the limit or, where that is out of reach, at one peak.
struct Corners {
  double up_m = 0;  ///< from the part's start
  double up2 = 0;
  double down_m = 0;
  double down2 = 0;
};
Corners corners_of(const SpeedPart& part, double accel_mps2, double brake_mps2);

/// Calls `run(leg, from, to)` for every run of constant acceleration, knots along the leg, and `wait(leg)`.
template <class Run, class Wait>
void each_run(const Profile& profile, std::span<const Leg> legs, Run run, const Wait& wait) {
  const std::vector<SpeedPart>& parts = profile.parts;
  double speed = parts.empty() ? 0 : std::sqrt(parts.front().start2);
  for (std::size_t i = 0; i < parts.size();) {
    const std::size_t leg = parts[i].leg;
    if (legs[leg].wait_s > 0) {
      wait(leg);
      ++i;
      continue;
    }
    Runs<Run> runs{leg, {0, parts[i].start2, speed}, run};
    for (; i < parts.size() && parts[i].leg == leg; ++i) {
      const SpeedPart& part = parts[i];
      const Corners c = corners_of(part, profile.accel_mps2, profile.brake_mps2);
      const double length = part.to_m - part.from_m;
      if (c.up_m > 0 && c.up_m < length) runs.add({part.from_m + c.up_m, c.up2, std::sqrt(c.up2)});
      if (c.down_m > c.up_m && c.down_m < length)
        runs.add({part.from_m + c.down_m, c.down2, std::sqrt(c.down2)});
      speed = std::sqrt(part.end2);
      runs.add({part.to_m, part.end2, speed});
    }
    runs.end();
  }
}

}  // namespace selion
