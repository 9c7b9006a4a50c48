// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "selion/core/machine.hpp"
#include "selion/motion/speed.hpp"

namespace selion {

/// How much of a limit is used where it is used most: 1 is all of it.
struct Use {
  double share = 0;
  std::size_t leg = 0;
  double s_m = 0;  ///< along that leg
};

struct LimitUse {
  Use curvature;      ///< of max_curvature_per_m()
  Use steering_rate;  ///< of max_steer_rate_deg_s, by steering_rate_rad_s()
  Use speed;          ///< of the leg's cap and max_speed_mps
  Use lateral;        ///< v^2 |curvature| of max_lateral_mps2
  Use acceleration;
  Use braking;
};

/// The largest use of each limit anywhere on the drive, not only at its samples: between two of them the
/// square of the speed and the curvature are linear along the way, so each limit's largest use is at an end
/// or where a derivative vanishes (a linear or quadratic equation). Legs below 1e-6 m and waits use nothing,
/// pivots speed (their wheels', of turn_speed_mps), acceleration and braking.
/// @pre the samples are those of drive() over the legs.
LimitUse limit_use(std::span<const Leg> legs, std::span<const Sample> samples, const Machine& machine);

}  // namespace selion
