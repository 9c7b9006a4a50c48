// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/speed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "profile.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/standing.hpp"

namespace selion {
namespace {

constexpr double kStraightStep_m = 100;
constexpr double kCurvedStep_m = 0.25;

class Drive {
 public:
  Drive(std::span<const Leg> legs, const Machine& machine) : legs_{legs}, machine_{machine} {
    double steps = 0;
    for (const Leg& leg : legs) steps += leg.stretch.curve.length_m / step_m(leg) + 3;
    samples_.reserve(static_cast<std::size_t>(steps));
  }

  /// `share` of a pivot's angle.
  void sample(std::size_t leg, double s_m, double speed_mps, double share) {
    const Stretch& stretch = legs_[leg].stretch;
    const CurveState state = state_at(stretch.curve, s_m);
    const bool reverse = stretch.gear == Gear::reverse;
    samples_.push_back({leg, s_m, t_s_, state.at,
                        wrapped((reverse ? state.heading_rad + std::numbers::pi : state.heading_rad) +
                                share * stretch.pivot_rad),
                        state.curvature_per_m, reverse && speed_mps > 0 ? -speed_mps : speed_mps,
                        legs_[leg].tool_down});
  }

  void rest(std::size_t leg) {
    const Leg& resting = legs_[leg];
    const double begin_s = t_s_;
    sample(leg, 0, 0, 0);
    if (is_pivot(resting.stretch)) {
      const Pivot pivot = pivot_of(machine_, resting.stretch.pivot_rad);
      const double slower = resting.wait_s / pivot.time_s();
      t_s_ = begin_s + slower * pivot.gain_s;
      sample(leg, 0, 0, pivot.gained);
      t_s_ += slower * pivot.steady_s;
      if (pivot.steady_s > 0) sample(leg, 0, 0, pivot.braking);
    }
    t_s_ = begin_s + resting.wait_s;
  }

  /// Samples from `from` on; `to` is left to whatever follows.
  void run(std::size_t leg, const Knot& from, const Knot& to) {
    const double length = to.s_m - from.s_m;
    const long steps = std::max(1L, std::lround(std::ceil(length / step_m(legs_[leg]) - 1e-9)));
    Knot last = from;
    for (long i = 1; i < steps; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(steps);
      const double speed2 = from.speed2 + share * (to.speed2 - from.speed2);
      step(leg, last, {from.s_m + share * length, speed2, std::sqrt(speed2)});
    }
    step(leg, last, to);
  }

  std::vector<Sample> samples() && { return std::move(samples_); }

 private:
  void step(std::size_t leg, Knot& last, const Knot& next) {
    sample(leg, last.s_m, last.speed_mps, 0);
    t_s_ += seconds(last, next);
    last = next;
  }

  static double step_m(const Leg& leg) {
    const Curve& curve = leg.stretch.curve;
    return curve.curvature_per_m != 0 || curve.sharpness_per_m2 != 0 ? kCurvedStep_m : kStraightStep_m;
  }

  std::span<const Leg> legs_;
  const Machine& machine_;
  std::vector<Sample> samples_;
  double t_s_ = 0;
};

}  // namespace

std::vector<Sample> drive(std::span<const Leg> legs, const Machine& machine, const EndSpeeds& ends) {
  if (legs.empty()) return {};
  const Profile profile = profile_of(legs, machine, ends);
  Drive driven{legs, machine};
  each_run(
      profile, legs,
      [&driven](std::size_t leg, const Knot& from, const Knot& to) { driven.run(leg, from, to); },
      [&driven](std::size_t leg) { driven.rest(leg); });
  const SpeedPart last = profile.parts.empty() ? SpeedPart{} : profile.parts.back();
  driven.sample(last.leg, last.to_m, std::sqrt(last.end2), 1);
  return std::move(driven).samples();
}

std::vector<Sample> drive(std::span<const Leg> legs, const Machine& machine) {
  return drive(legs, machine, EndSpeeds{});
}

double duration_s(std::span<const Leg> legs, const Machine& machine, const EndSpeeds& ends) {
  double sum_s = 0;
  each_run(
      profile_of(legs, machine, ends), legs,
      [&sum_s](std::size_t, const Knot& from, const Knot& to) { sum_s += seconds(from, to); },
      [&sum_s, legs](std::size_t leg) { sum_s += legs[leg].wait_s; });
  return sum_s;
}

}  // namespace selion
