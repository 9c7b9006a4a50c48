// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/speed.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr double kNoLeg_m = 1e-6;        // legs shorter than this take no time
constexpr double kLeastCorner_s = 5e-4;  // corners of the profile nearer to each other than this are one
constexpr double kStraightStep_m = 100;
constexpr double kCurvedStep_m = 0.25;

/// A leg that takes time, with the squares of its speeds.
struct Part {
  std::size_t leg = 0;
  double length_m = 0;  ///< 0 for a wait
  double cap2 = 0;
  double start2 = 0;
  double end2 = 0;
};

double cap_of(const Leg& leg, const Machine& machine) {
  const Curve& curve = leg.stretch.curve;
  const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
  const double curvature = std::max(std::abs(curve.curvature_per_m), std::abs(end));
  return std::min(leg.speed_cap_mps, max_speed_mps(machine, curvature, std::abs(curve.sharpness_per_m2)));
}

std::vector<Part> parts_of(std::span<const Leg> legs, const Machine& machine) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    if (leg.wait_s > 0) {
      parts.push_back({i, 0, 0, 0, 0});
    } else if (leg.stretch.curve.length_m >= kNoLeg_m) {
      const double cap = cap_of(leg, machine);
      assert(cap > 0);
      parts.push_back({i, leg.stretch.curve.length_m, cap * cap, 0, 0});
    }
  }
  return parts;
}

/// Speeds at the joints: the lower cap, less where it cannot be reached from before or braked from to what
/// follows.
void set_speeds(std::vector<Part>& parts, std::span<const Leg> legs, const Machine& machine) {
  for (std::size_t i = 1; i < parts.size(); ++i) {
    Part& last = parts[i - 1];
    Part& next = parts[i];
    const bool rest = legs[last.leg].stretch.gear != legs[next.leg].stretch.gear;
    const double reached = last.start2 + 2 * machine.max_accel_mps2 * last.length_m;
    last.end2 = rest ? 0 : std::min({last.cap2, next.cap2, reached});
    next.start2 = last.end2;
  }
  double after = 0;
  for (std::size_t i = parts.size(); i-- > 0;) {
    Part& part = parts[i];
    part.end2 = after;
    part.start2 = std::min(part.start2, after + 2 * machine.max_brake_mps2 * part.length_m);
    after = part.start2;
  }
}

/// A corner of the profile: the square of the speed is linear in between.
struct Knot {
  double s_m = 0;
  double speed2 = 0;
};

double seconds(const Knot& from, const Knot& to) {
  return 2 * (to.s_m - from.s_m) / (std::sqrt(from.speed2) + std::sqrt(to.speed2));
}

/// Accelerate, keep the cap, brake. Corners too near to another are left out where the rest can do without:
/// the slopes then are gentler.
std::vector<Knot> corners_of(const Part& part, const Machine& machine) {
  const double a = machine.max_accel_mps2;
  const double b = machine.max_brake_mps2;
  const double reached2 = (2 * a * b * part.length_m + b * part.start2 + a * part.end2) / (a + b);
  const double top2 = std::max({std::min(part.cap2, reached2), part.start2, part.end2});
  const Knot start{0, part.start2};
  const Knot end{part.length_m, part.end2};
  const Knot up{std::clamp((top2 - part.start2) / (2 * a), 0.0, part.length_m), top2};
  const Knot down{std::clamp(part.length_m - (top2 - part.end2) / (2 * b), up.s_m, part.length_m), top2};
  if (part.start2 == 0 && part.end2 == 0) {
    return seconds(up, down) < kLeastCorner_s ? std::vector{start, up, end}
                                              : std::vector{start, up, down, end};
  }
  std::vector<Knot> corners{start};
  for (const Knot& corner : {up, down}) {
    if (seconds(corners.back(), corner) >= kLeastCorner_s && seconds(corner, end) >= kLeastCorner_s)
      corners.push_back(corner);
  }
  corners.push_back(end);
  return corners;
}

class Drive {
 public:
  explicit Drive(std::span<const Leg> legs) : legs_{legs} {}

  void sample(std::size_t leg, double s_m, double speed2) {
    const Stretch& stretch = legs_[leg].stretch;
    const CurveState state = state_at(stretch.curve, s_m);
    const double speed = std::sqrt(speed2);
    const bool backwards = stretch.gear == Gear::reverse && speed > 0;
    samples_.push_back({leg, s_m, t_s_, state.at, wrapped(vehicle_heading(stretch, state)),
                        state.curvature_per_m, backwards ? -speed : speed, legs_[leg].tool_down});
  }

  void wait(std::size_t leg) {
    sample(leg, 0, 0);
    t_s_ += legs_[leg].wait_s;
  }

  /// Samples from `from` on; `to` is left to whatever follows.
  void run(std::size_t leg, const Knot& from, const Knot& to) {
    const Curve& curve = legs_[leg].stretch.curve;
    const bool curved = curve.curvature_per_m != 0 || curve.sharpness_per_m2 != 0;
    const double length = to.s_m - from.s_m;
    const auto steps =
        std::max(1L, std::lround(std::ceil(length / (curved ? kCurvedStep_m : kStraightStep_m) - 1e-9)));
    Knot last = from;
    for (long i = 1; i <= steps; ++i) {
      sample(leg, last.s_m, last.speed2);
      const double share = static_cast<double>(i) / static_cast<double>(steps);
      const Knot next{from.s_m + share * length, from.speed2 + share * (to.speed2 - from.speed2)};
      t_s_ += seconds(last, next);
      last = next;
    }
  }

  std::vector<Sample> samples() && { return std::move(samples_); }

 private:
  static double vehicle_heading(const Stretch& stretch, const CurveState& state) {
    return stretch.gear == Gear::forward ? state.heading_rad : wrapped(state.heading_rad + std::numbers::pi);
  }

  std::span<const Leg> legs_;
  std::vector<Sample> samples_;
  double t_s_ = 0;
};

}  // namespace

std::vector<Sample> drive(std::span<const Leg> legs, const Machine& machine) {
  if (legs.empty()) return {};
  std::vector<Part> parts = parts_of(legs, machine);
  set_speeds(parts, legs, machine);
  Drive driven{legs};
  for (const Part& part : parts) {
    if (part.length_m == 0) {
      driven.wait(part.leg);
      continue;
    }
    const std::vector<Knot> corners = corners_of(part, machine);
    for (std::size_t i = 1; i < corners.size(); ++i) driven.run(part.leg, corners[i - 1], corners[i]);
  }
  driven.sample(parts.empty() ? 0 : parts.back().leg, parts.empty() ? 0 : parts.back().length_m, 0);
  return std::move(driven).samples();
}

}  // namespace selion
