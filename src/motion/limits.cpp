// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "selion/core/units.hpp"
#include "selion/motion/standing.hpp"

namespace selion {
namespace {

/// What is driven between two samples: along the leg from `from_m`, the square of the speed and the curvature
/// linear in the way.
struct Run {
  std::size_t leg = 0;
  double from_m = 0;
  double length_m = 0;
  double speed2 = 0;
  double gain = 0;  ///< of speed2 for every metre
  double curvature = 0;
  double sharpness = 0;

  [[nodiscard]] double speed2_at(double x_m) const { return std::max(0.0, speed2 + gain * x_m); }
  [[nodiscard]] double curvature_at(double x_m) const { return curvature + sharpness * x_m; }
};

void raise(Use& use, const Run& run, double x_m, double share) {
  if (share > use.share) use = {share, run.leg, run.from_m + x_m};
}

/// Places at which a share can be largest: both ends, and of the given ones those between.
template <class Share>
void raise_at(Use& use, const Run& run, const std::array<double, 2>& inner_m, const Share& share) {
  raise(use, run, 0, share(0.0));
  raise(use, run, run.length_m, share(run.length_m));
  for (const double x : inner_m)
    if (x > 0 && x < run.length_m) raise(use, run, x, share(x));  // a NaN is not
}

void lateral(Use& use, const Run& run, double limit_mps2) {
  const double top =
      -(run.speed2 * run.sharpness + run.gain * run.curvature) / (2 * run.gain * run.sharpness);
  raise_at(use, run, {top, top},
           [&](double x) { return run.speed2_at(x) * std::abs(run.curvature_at(x)) / limit_mps2; });
}

/// v / (1 + (L k)^2) is largest where, with v^2 = p + q k, q - 4 L^2 p k - 3 L^2 q k^2 = 0.
std::array<double, 2> fastest_steering_m(const Run& run, const Machine& machine) {
  if (machine.kind != MachineKind::car || run.sharpness == 0) return {-1, -1};
  const double base2 = machine.wheelbase_m * machine.wheelbase_m;
  const double q = run.gain / run.sharpness;
  const double p = run.speed2 - q * run.curvature;
  const double half = 2 * base2 * p;
  const double root = std::sqrt(half * half + 3 * base2 * q * q);
  const double large = -(half + std::copysign(root, half));  // of the two the one without cancellation
  const double one = large / (3 * base2 * q);
  const double other = -q / large;
  return {(one - run.curvature) / run.sharpness, (other - run.curvature) / run.sharpness};
}

void steering(Use& use, const Run& run, const Machine& machine) {
  const double limit = radians_of_degrees(machine.max_steer_rate_deg_s);
  raise_at(use, run, fastest_steering_m(run, machine), [&](double x) {
    return steering_rate_rad_s(machine, run.curvature_at(x), run.sharpness, std::sqrt(run.speed2_at(x))) /
           limit;
  });
}

void add(LimitUse& use, const Run& run, const Leg& leg, const Machine& machine) {
  const double curvature = max_curvature_per_m(machine);
  const double cap = std::min(leg.speed_cap_mps, machine.max_speed_mps);
  raise_at(use.curvature, run, {-1, -1}, [&](double x) { return std::abs(run.curvature_at(x)) / curvature; });
  raise_at(use.speed, run, {-1, -1}, [&](double x) { return std::sqrt(run.speed2_at(x)) / cap; });
  lateral(use.lateral, run, machine.max_lateral_mps2);
  steering(use.steering_rate, run, machine);
  raise(use.acceleration, run, 0, run.gain / 2 / machine.max_accel_mps2);
  raise(use.braking, run, 0, -run.gain / 2 / machine.max_brake_mps2);
}

/// A pivot in less time than pivot_s() is that pivot with every speed so much higher.
void add_pivot(LimitUse& use, std::size_t index, const Leg& leg, const Machine& machine) {
  const Pivot pivot = pivot_of(machine, leg.stretch.pivot_rad);
  const double faster = pivot.time_s() / leg.wait_s;
  const double peak_mps = pivot.gain_s * machine.max_accel_mps2;
  const Run run{.leg = index};
  raise(use.speed, run, 0, faster * peak_mps / machine.turn_speed_mps);
  raise(use.acceleration, run, 0, faster * faster);
  raise(use.braking, run, 0, faster * faster);
}

}  // namespace

LimitUse limit_use(std::span<const Leg> legs, std::span<const Sample> samples, const Machine& machine) {
  constexpr double kNoLeg_m = 1e-6;
  LimitUse use;
  for (std::size_t i = 0; i < legs.size(); ++i)
    if (is_pivot(legs[i].stretch)) add_pivot(use, i, legs[i], machine);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& from = samples[i - 1];
    const Sample& to = samples[i];
    const Leg& leg = legs[from.leg];
    const Curve& curve = leg.stretch.curve;
    if (leg.wait_s > 0 || curve.length_m < kNoLeg_m) continue;
    const double length = (to.leg == from.leg ? to.s_m : curve.length_m) - from.s_m;
    const double speed2 = from.speed_mps * from.speed_mps;
    const double gain = (to.speed_mps * to.speed_mps - speed2) / length;
    const double curvature = curve.curvature_per_m + curve.sharpness_per_m2 * from.s_m;
    add(use, {from.leg, from.s_m, length, speed2, gain, curvature, curve.sharpness_per_m2}, leg, machine);
  }
  return use;
}

}  // namespace selion
