// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kTime_s = 1e-4;     // of the rounding of two times
constexpr double kSpeed_mps = 1e-4;  // of a speed's rounding
constexpr double kNear_m = 1e-3;     // of a place: the sample may stand there
constexpr double kTurn = 2 * std::numbers::pi;

/// The slowest that the robot is at a place; where no sample stands there, of the samples around it.
double slowest_mps(const Driven& driven, double way_m) {
  const auto& moments = driven.moments;
  auto at = std::ranges::lower_bound(moments, way_m - kNear_m, {}, &Moment::way_m);
  if (at == moments.end()) return moments.back().speed_mps;
  double slowest = at->speed_mps;
  for (++at; at != moments.end() && at->way_m <= way_m + kNear_m; ++at)
    slowest = std::min(slowest, at->speed_mps);
  return slowest;
}

/// Where pieces wait, pivot or change the gear.
void check_stop(Case& plan, const Driven& driven, std::size_t i) {
  const PieceLine& piece = driven.pieces[i];
  const bool turns_back = i > 0 && driven.pieces[i - 1].record().gear != piece.record().gear;
  if (!piece.stands() && !turns_back) return;
  const Machine& m = plan.vehicle.machine;
  const double slack = kSpeed_mps + 2 * kTime_s * std::max(m.max_accel_mps2, m.max_brake_mps2);
  const double speed = slowest_mps(driven, driven.begin_m[i]);
  if (speed <= slack) return;
  plan.findings.add("rest", driven.record->block, piece.spot(0).at, {speed, 0},
                    piece_name(driven, i) + " begins at " + shown(speed, 3) + " m/s, where the machine " +
                        (piece.stands() ? "must stand" : "changes its gear"));
}

/// Of a car's wheels, or a joint, at the end of a piece or its begin.
double steering_rad(const Machine& machine, const PieceLine& piece, double s_m) {
  return std::atan(machine.wheelbase_m * piece.record().gear * piece.curvature_per_m(s_m));
}

/// The wheels turn while the machine stands, where the next piece begins with another curvature than the one
/// before ends with.
void check_steering(Case& plan, const Driven& driven) {
  if (plan.vehicle.machine.kind == MachineKind::differential) return;
  constexpr double kSlack_s = 2e-3;
  const PieceLine* before = nullptr;
  double rest_s = 0;
  for (const PieceLine& piece : driven.pieces) {
    if (piece.stands()) {
      rest_s += piece.record().duration_s.value_or(0);
      continue;
    }
    const double by_rad = before == nullptr
                              ? 0
                              : std::abs(steering_rad(plan.vehicle.machine, piece, 0) -
                                         steering_rad(plan.vehicle.machine, *before, before->length_m()));
    const double least_s = by_rad / plan.vehicle.most_steering_rad_s;
    const bool stands = before != nullptr && (rest_s > 0 || before->record().gear != piece.record().gear);
    if (stands && !(rest_s >= least_s * (1 - 1e-3) - kSlack_s))
      plan.findings.add("steering_rate", driven.record->block, piece.spot(0).at,
                        {by_rad / std::max(rest_s, kSlack_s), plan.vehicle.most_steering_rad_s},
                        "the machine rests for " + shown(rest_s, 2) + " s where its wheels take " +
                            shown(least_s, 2) + " s to turn by " + shown(by_rad, 3) + " rad");
    before = &piece;
    rest_s = 0;
  }
}

/// The robot stands as long as its waits and pivots last, those together that are as near as no sample tells
/// them apart.
class RestCheck {
 public:
  RestCheck(Case& plan, const Driven& driven) : plan_{plan}, driven_{driven} {}

  void run() {
    for (std::size_t piece = 0; piece < driven_.pieces.size(); ++piece) {
      if (!driven_.pieces[piece].stands()) continue;
      const double way = driven_.begin_m[piece];
      double asked = 0;
      for (; piece < driven_.pieces.size() && driven_.begin_m[piece] <= way + kNear_m; ++piece)
        asked += driven_.pieces[piece].record().duration_s.value_or(0);
      --piece;
      const double rested = rested_s(way);
      compare({rested, asked});
    }
  }

 private:
  /// At a place; on from where it rested last.
  double rested_s(double way_m) {
    const auto& moments = driven_.moments;
    double rested = 0;
    for (; i_ < moments.size() && moments[i_ - 1].way_m <= way_m + kNear_m; ++i_)
      if (moments[i_].way_m <= way_m + kNear_m && moments[i_ - 1].way_m >= way_m - kNear_m)
        rested += moments[i_].t_s - moments[i_ - 1].t_s;
    return rested;
  }

  /// It may take somewhat longer: to come as near, and to leave.
  void compare(const Measured& rest) {
    const Machine& m = plan_.vehicle.machine;
    const double slow_s = 2 * std::sqrt(4 * kNear_m / std::min(m.max_accel_mps2, m.max_brake_mps2));
    if (rest.measure >= rest.limit - 2e-3 && rest.measure <= rest.limit + slow_s) return;
    const Moment& end = driven_.moments[std::min(i_, driven_.moments.size()) - 1];
    plan_.findings.add("rest", driven_.record->block, driven_.spot(end.way_m).at, rest,
                       "robot " + std::to_string(driven_.record->robot) + " ends a rest at " +
                           shown(end.t_s, 1) + " s of " + shown(rest.measure, 2) + " s, other than the " +
                           shown(rest.limit, 2) + " s asked for");
  }

  Case& plan_;
  const Driven& driven_;
  std::size_t i_ = 1;  ///< the next moment
};

/// How fast a machine rotates on the spot: between samples the rate changes evenly (docs/plan.md).
class SpinCheck {
 public:
  SpinCheck(Case& plan, const Driven& driven) : plan_{plan}, driven_{driven} {
    const Machine& m = plan.vehicle.machine;
    const double wheels = 2 / m.track_m;
    most_rad_s_ = wheels * m.turn_speed_mps;
    gain_ = wheels * m.max_accel_mps2, loss_ = wheels * m.max_brake_mps2;
  }

  void run() {
    for (std::size_t i = 1; i < driven_.moments.size(); ++i)
      interval(driven_.moments[i - 1], driven_.moments[i]);
  }

 private:
  void interval(const Moment& a, const Moment& b) {
    constexpr double kStill_rad = 1e-5;
    const double turned = std::abs(std::remainder(b.heading_rad - a.heading_rad, kTurn));
    const double span = b.t_s - a.t_s;
    const bool stands = a.speed_mps <= kSpeed_mps && b.speed_mps <= kSpeed_mps;
    if (!stands || turned <= kStill_rad || !(span > 0)) {
      rate_ = off_ = 0;
      return;
    }
    const double rate = 2 * turned / span - rate_;
    const double off = off_ + 2 * (kStill_rad + most_rad_s_ * kTime_s) / span;
    const double change = (rate > rate_ ? gain_ : loss_) * (span + kTime_s);
    if (turned > most_rad_s_ * (span + kTime_s) + kStill_rad || std::abs(rate) > most_rad_s_ + off ||
        std::abs(rate - rate_) > change + off + off_)
      say(a, {turned / span, most_rad_s_});
    rate_ = rate, off_ = off;
  }

  void say(const Moment& at, Measured rate) {
    plan_.findings.add("pivot_time", driven_.record->block, driven_.spot(at.way_m).at, rate,
                       "robot " + std::to_string(driven_.record->robot) + " rotates by " +
                           shown(rate.measure, 3) + " rad/s at " + shown(at.t_s, 1) +
                           " s, from or to rest faster than its wheels; they reach " + shown(rate.limit, 3));
  }

  Case& plan_;
  const Driven& driven_;
  double most_rad_s_ = 0;
  double gain_ = 0;  ///< of that rate, in rad/s2
  double loss_ = 0;
  double rate_ = 0;  ///< at the sample before
  double off_ = 0;   ///< what roundings may make of it
};

}  // namespace

void check_stops(Case& plan, const Driven& driven) {
  if (driven.moments.empty()) return;
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) check_stop(plan, driven, i);
  check_steering(plan, driven);
  RestCheck{plan, driven}.run();
  SpinCheck{plan, driven}.run();
}

}  // namespace selion::verifying
