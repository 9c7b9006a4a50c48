// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/motion/speed.hpp"

namespace selion {

/// What a machine's limits come to, once for a drive.
struct SpeedLimits {
  double speed_mps = 0;
  double lateral_mps2 = 0;
  double rate_m_per_s = 0;  ///< steering rate by steering base: sharpness times speed on a straight path
  double base2_m2 = 0;      ///< the steering base squared where curvature eases the steering rate, else 0
};
SpeedLimits speed_limits(const Machine& machine);

/// A piece of a leg, or a wait (then from_m = to_m = 0), and the square of the speed at its ends: allowed
/// (linear in between) and driven.
struct SpeedPart {
  std::size_t leg = 0;
  double from_m = 0;  ///< along the leg
  double to_m = 0;
  double from2 = 0;
  double to2 = 0;
  double start2 = 0;
  double end2 = 0;
};

/// Appends the leg's parts. Their allowed speed nowhere exceeds min(the leg's cap, max_speed_mps()), and
/// falls short of it by less than 2 %, by half a percent on average.
void add_parts(std::vector<SpeedPart>& parts, std::size_t index, const Leg& leg, const SpeedLimits& limits);

}  // namespace selion
