// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/core/machine.hpp"
#include "selion/motion/path.hpp"

namespace selion {

/// How the wheels roll while a machine rotates on the spot, from rest to rest, those of one side ahead and
/// those of the other back: they gain speed up to turn_speed_mps, keep it, brake. Over an angle too small for
/// that they brake as soon as they must.
struct Pivot {
  double gain_s = 0;
  double steady_s = 0;
  double brake_s = 0;
  double gained = 0;   ///< share of the angle where they stop gaining speed
  double braking = 1;  ///< share of the angle where they begin to brake

  [[nodiscard]] double time_s() const { return gain_s + steady_s + brake_s; }
};

/// Each side rolls d = |angle| track / 2 with the machine's max_accel a and max_brake b. Where d reaches
/// v^2/2a + v^2/2b, v = turn_speed_mps (a rotation at 2 v / track), it takes d/v + v/2a + v/2b; else
/// sqrt(2 d (1/a + 1/b)).
Pivot pivot_of(const Machine& machine, double angle_rad);
double pivot_s(const Machine& machine, double angle_rad);

/// What each side's tyres slide over the ground in a pivot: the way that its wheels are apart from rolling
/// straight.
double scrub_m(const Machine& machine, double angle_rad);

/// Time to turn the steered wheels from how they stand at the end of `before` to how they stand at the start
/// of `after`: none where curvature is continuous, and none for a differential machine.
double steering_s(const Machine& machine, const Stretch& before, const Stretch& after);

/// Where the machine stands at the end of a stretch, as a stretch of length 0 in its gear.
Stretch standing_after(const Stretch& stretch);

}  // namespace selion
