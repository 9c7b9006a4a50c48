// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile.hpp"

#include <cassert>

namespace selion {
namespace {

constexpr double kNoLeg_m = 1e-6;  // legs shorter than this take no time

std::vector<SpeedPart> parts_of(std::span<const Leg> legs, const Machine& machine) {
  const SpeedLimits limits = speed_limits(machine);
  std::vector<SpeedPart> parts;
  parts.reserve(2 * legs.size() + 8);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].wait_s > 0) {
      parts.push_back({i, 0, 0, 0, 0, 0, 0});
    } else if (legs[i].stretch.curve.length_m >= kNoLeg_m) {
      assert(legs[i].speed_cap_mps > 0);
      add_parts(parts, i, legs[i], limits);
    }
  }
  return parts;
}

}  // namespace

/// Speeds at the joints: the lower of what both sides allow, less where it cannot be reached from before or
/// braked from to what follows.
Profile profile_of(std::span<const Leg> legs, const Machine& machine, const EndSpeeds& ends) {
  Profile profile{parts_of(legs, machine), machine.max_accel_mps2, machine.max_brake_mps2};
  std::vector<SpeedPart>& parts = profile.parts;
  double before2 = ends.start_mps * ends.start_mps;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    SpeedPart& part = parts[i];
    const bool turned = i > 0 && legs[parts[i - 1].leg].stretch.gear != legs[part.leg].stretch.gear;
    part.start2 = turned ? 0 : std::min(before2, part.from2);
    before2 = std::min(part.to2, part.start2 + 2 * profile.accel_mps2 * (part.to_m - part.from_m));
  }
  double after2 = std::min(ends.end_mps * ends.end_mps, before2);
  for (std::size_t i = parts.size(); i-- > 0;) {
    SpeedPart& part = parts[i];
    part.end2 = after2;
    part.start2 = std::min(part.start2, after2 + 2 * profile.brake_mps2 * (part.to_m - part.from_m));
    after2 = part.start2;
  }
  return profile;
}

Corners corners_of(const SpeedPart& part, double accel_mps2, double brake_mps2) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double length = part.to_m - part.from_m;
  const double rise = 2 * accel_mps2;
  const double fall = 2 * brake_mps2;
  const double slope = length > 0 ? (part.to2 - part.from2) / length : 0;
  if (part.start2 == part.from2 && part.end2 == part.to2 && slope <= rise && slope >= -fall)
    return {0, part.start2, length, part.end2};  // along the limit
  const double up = slope < rise ? (part.from2 - part.start2) / (rise - slope) : kNever;
  const double down = slope > -fall ? (part.to2 - part.end2) / (fall + slope) : kNever;
  if (up + down <= length) return {up, part.from2 + slope * up, length - down, part.to2 - slope * down};
  const double peak = std::clamp((part.end2 - part.start2 + fall * length) / (rise + fall), 0.0, length);
  const double peak2 = part.start2 + rise * peak;
  return {peak, peak2, peak, peak2};
}

}  // namespace selion
