// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>

#include "motion_drives.hpp"
#include "selion/core/units.hpp"

using namespace selion;

namespace {

/// The limit of the square of the speed and the way to the next place, every millimetre at most.
struct Grid {
  std::vector<double> most2;
  std::vector<double> step_m;
};

Grid grid_of(const std::vector<Leg>& legs, const Machine& m) {
  Grid grid{{1e9}, {}};
  for (const Leg& leg : legs) {
    const Curve& c = leg.stretch.curve;
    const int steps = static_cast<int>(std::ceil(c.length_m / 1e-3));
    for (int i = 0; i <= steps; ++i) {
      const double k = c.curvature_per_m + c.sharpness_per_m2 * c.length_m * i / steps;
      const double most = std::min(leg.speed_cap_mps, max_speed_mps(m, k, c.sharpness_per_m2));
      if (i > 0) {
        grid.step_m.push_back(c.length_m / steps);
        grid.most2.push_back(1e9);
      }
      grid.most2.back() = std::min(grid.most2.back(), most * most);
    }
  }
  return grid;
}

/// Forward and backward over the grid: what the closed form is compared with.
double least_time_s(const std::vector<Leg>& legs, const Machine& m) {
  Grid grid = grid_of(legs, m);
  std::vector<double>& v2 = grid.most2;
  v2.front() = v2.back() = 0;
  for (std::size_t i = 1; i < v2.size(); ++i)
    v2[i] = std::min(v2[i], v2[i - 1] + 2 * m.max_accel_mps2 * grid.step_m[i - 1]);
  for (std::size_t i = v2.size() - 1; i-- > 0;)
    v2[i] = std::min(v2[i], v2[i + 1] + 2 * m.max_brake_mps2 * grid.step_m[i]);
  double sum = 0;
  for (std::size_t i = 1; i < v2.size(); ++i)
    sum += 2 * grid.step_m[i - 1] / (std::sqrt(v2[i - 1]) + std::sqrt(v2[i]));
  return sum;
}

/// The largest shares at a thousand places between each two samples.
struct Seen {
  double lateral = 0;
  double steering_rate = 0;
};

Seen seen_use(const std::vector<Leg>& legs, const std::vector<Sample>& samples, const Machine& m) {
  Seen seen;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& a = samples[i - 1];
    const Curve& c = legs[a.leg].stretch.curve;
    const double length = (samples[i].leg == a.leg ? samples[i].s_m : c.length_m) - a.s_m;
    for (int j = 0; j <= 1000; ++j) {
      const double t = j / 1000.0;
      const double v =
          std::sqrt(std::lerp(a.speed_mps * a.speed_mps, samples[i].speed_mps * samples[i].speed_mps, t));
      const double k = c.curvature_per_m + c.sharpness_per_m2 * (a.s_m + t * length);
      seen.lateral = std::max(seen.lateral, v * v * std::abs(k) / m.max_lateral_mps2);
      seen.steering_rate = std::max(seen.steering_rate, steering_rate_rad_s(m, k, c.sharpness_per_m2, v) /
                                                            radians_of_degrees(m.max_steer_rate_deg_s));
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("no limit is exceeded anywhere between samples", "[motion][limits]") {
  double most_lateral = 0;
  double most_steering = 0;
  for (Machine m : limited_machines()) {
    m.min_turn_radius_m = 1.0;
    for (unsigned seed = 0; seed < 40; ++seed) {
      const auto legs = winding_legs(seed);
      const LimitUse use = limit_use(legs, drive(legs, m), m);
      CAPTURE(seed);
      check_within(use);
      most_lateral = std::max(most_lateral, use.lateral.share);
      most_steering = std::max(most_steering, use.steering_rate.share);
    }
  }
  CHECK(most_lateral > 0.999);  // the limits ruled somewhere
  CHECK(most_steering > 0.999);
}

TEST_CASE("a drive takes at most 0.5 % longer than the fastest that there is", "[motion][limits]") {
  double worst = 0;
  for (const Machine& m : limited_machines())
    for (unsigned seed = 0; seed < 12; ++seed) {
      const auto legs = winding_legs(seed);
      const double longer = duration_s(legs, m, {}) / least_time_s(legs, m) - 1;
      CAPTURE(seed, longer);
      CHECK(longer > -1e-3);  // the grid misses joints of caps by less than a millimetre
      CHECK(longer < 5e-3);
      worst = std::max(worst, longer);
    }
  CAPTURE(worst);
  CHECK(worst > 1e-5);
}

TEST_CASE("the largest use of a limit is found between samples too", "[motion][limits]") {
  for (const Machine& m : limited_machines())
    for (unsigned seed = 0; seed < 4; ++seed) {
      const auto legs = winding_legs(seed);
      auto samples = drive(legs, m);
      std::vector<Sample> some;  // long ways between samples: the largest use lies inside
      for (std::size_t i = 0; i < samples.size(); ++i)
        if (i % 4 == 0 || samples[i].s_m == 0 || i + 1 == samples.size()) some.push_back(samples[i]);
      const LimitUse use = limit_use(legs, some, m);
      const Seen seen = seen_use(legs, some, m);
      CAPTURE(seed);
      CHECK(use.lateral.share >= seen.lateral * (1 - 1e-12));
      CHECK(use.lateral.share == Approx(seen.lateral).epsilon(1e-4));
      CHECK(use.steering_rate.share >= seen.steering_rate * (1 - 1e-12));
      CHECK(use.steering_rate.share == Approx(seen.steering_rate).epsilon(1e-4));
    }
}

TEST_CASE("what breaks a limit is found with its place", "[motion][limits]") {
  const Machine m;
  const std::vector<Leg> legs{{{{{}, 0, 0, 0.5, 1}}, 9}};  // curvature to 0.5 within a metre
  const auto at = [](double s_m, double t_s, double speed) {
    return Sample{0, s_m, t_s, {}, 0, 0, speed, false};
  };
  const std::vector<Sample> samples{at(0, 0, 2), at(1, 0.4, 3)};
  const LimitUse use = limit_use(legs, samples, m);
  CHECK(use.lateral.share == Approx(9 * 0.5 / m.max_lateral_mps2));
  CHECK(use.lateral.s_m == 1);
  CHECK(use.curvature.share == Approx(0.5 * m.wheelbase_m));  // 45 degrees
  CHECK(use.acceleration.share == Approx((9 - 4) / 2.0 / m.max_accel_mps2));
  CHECK(use.speed.share == Approx(1));
  // v / (1 + (1.8 k)^2) is largest where 10 - 4 x 3.24 x 4 k - 3 x 3.24 x 10 k^2 = 0: k = .1505
  CHECK(use.steering_rate.s_m == Approx(0.3009).epsilon(1e-3));
}

TEST_CASE("a duration is that of the drive", "[motion][speed]") {
  const EndSpeeds ends = GENERATE(EndSpeeds{0, 0}, EndSpeeds{2, 0.5}, EndSpeeds{9, 9});
  for (const Machine& m : limited_machines())
    for (unsigned seed = 0; seed < 10; ++seed) {
      auto legs = winding_legs(seed);
      const Path back = backed({legs.back().stretch});  // reverse and a cusp
      legs.push_back({back.front(), 1});
      Leg wait{{{back.front().curve.start, 0, 0, 0, 0}}, 0};
      wait.wait_s = 3;
      legs.insert(legs.begin() + 7, wait);
      const auto samples = drive(legs, m, ends);
      CHECK(duration_s(legs, m, ends) == Approx(samples.back().t_s).epsilon(1e-12));
      CHECK(samples.front().speed_mps <= ends.start_mps);
      CHECK(std::abs(samples.back().speed_mps) <= ends.end_mps);
      check_within(limit_use(legs, samples, [&] {
        Machine tight = m;
        tight.min_turn_radius_m = 1.0;
        return tight;
      }()));
    }
}
