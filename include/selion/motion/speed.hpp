// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/motion/path.hpp"

namespace selion {

/// What is driven: a stretch with its cap (on top of the machine's own limits), or a rest where `wait_s` > 0
/// (the stretch then has length 0): a wait, or a pivot that takes so long.
struct Leg {
  Stretch stretch;
  double speed_cap_mps = 0;
  bool tool_down = false;
  double wait_s = 0;
};

/// A moment of the drive. Between two samples acceleration is constant.
struct Sample {
  std::size_t leg = 0;
  double s_m = 0;  ///< along that leg
  double t_s = 0;
  Point at;
  double heading_rad = 0;      ///< of the vehicle, in (-pi, pi]
  double curvature_per_m = 0;  ///< with respect to travel
  double speed_mps = 0;        ///< negative in reverse
  bool tool_down = false;      ///< from here to the next sample
};

/// Speeds where the legs begin and end, m/s ahead in the gear of the leg. They are lowered to what the limits
/// there allow, to what can be reached and to what can be braked from.
struct EndSpeeds {
  double start_mps = 0;
  double end_mps = 0;
};

/// Fastest drive over the legs below the limits at every place: caps, max_speed_mps() with its lateral
/// acceleration and exact steering rate, acceleration and braking; at rest at changes of gear, waits and
/// pivots. No limit is exceeded between samples; where lateral acceleration or steering rate rules, the speed
/// is at most 2 % below it. A sample stands at every end of a leg, every corner of the speed profile, every
/// tool change and wait, and at most 0.25 m apart where the curve bends, 100 m on straights. A pivot has
/// samples where it begins, stops speeding up and begins to brake, as pivot_of() says, stretched to the time
/// given. Times increase strictly (a rest repeats the position). A joint of legs is one sample, of the later
/// leg. Legs below 1e-6 m take no time and have no sample; corners of the profile within 0.5 ms of each other
/// are one where the profile without them stays below the limits. Linear in legs and length. Bobrow, Dubowsky
/// and Gibson 1985.
/// @pre every leg with a length has a cap above 0, every pivot a time.
std::vector<Sample> drive(std::span<const Leg> legs, const Machine& machine, const EndSpeeds& ends);
/// From and to rest.
std::vector<Sample> drive(std::span<const Leg> legs, const Machine& machine);

/// Time of that same drive, to rounding, without its samples.
double duration_s(std::span<const Leg> legs, const Machine& machine, const EndSpeeds& ends);

}  // namespace selion
