// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kSpeed_mps = 1.5e-4;  // of the rounding of speeds, times and places
constexpr double kSlack = 1 + 3e-4;    // what is left out where two samples fall together
constexpr double kTime_s = 1e-4;       // of the rounding of two times

/// A part of a piece on which the square of the speed grows evenly with the way.
struct Part {
  double from_m;  ///< along the piece's curve
  double to_m;
  double from_speed2;
  double to_speed2;

  [[nodiscard]] double speed2(double s_m) const {
    if (!(to_m > from_m)) return std::max(from_speed2, to_speed2);
    return from_speed2 + (s_m - from_m) / (to_m - from_m) * (to_speed2 - from_speed2);
  }
};

/// The largest value of a function that has one peak.
template <class Function>
double largest(double from, double to, Function of) {
  constexpr double kGolden = 0.6180339887498949;
  double most = std::max(of(from), of(to));
  for (int i = 0; i < 30; ++i) {
    const double a = to - kGolden * (to - from);
    const double b = from + kGolden * (to - from);
    const double of_a = of(a);
    const double of_b = of(b);
    most = std::max({most, of_a, of_b});
    (of_a < of_b ? from : to) = of_a < of_b ? a : b;
  }
  return most;
}

/// The moment from which a speed is most below what a steady gain would have made of it: a gain is too large
/// between some moment and a later one if it is from that one, so roundings do not add up over many.
struct Steady {
  double limit_mps2;
  double sign;  ///< -1: of braking
  const Moment* from = nullptr;

  /// Above what a steady gain since then makes of the speed there.
  [[nodiscard]] double above_mps(const Moment& to) const {
    return sign * (to.speed_mps - from->speed_mps) - limit_mps2 * (to.t_s - from->t_s);
  }
};

class SpeedCheck {
 public:
  SpeedCheck(Case& plan, const Driven& driven)
      : plan_{plan},
        driven_{driven},
        gains_{Steady{plan.vehicle.machine.max_accel_mps2 * kSlack, 1},
               Steady{plan.vehicle.machine.max_brake_mps2 * kSlack, -1}} {}

  void run() {
    std::size_t piece = 0;
    if (!driven_.moments.empty())
      for (Steady& steady : gains_) steady.from = &driven_.moments.front();
    for (std::size_t i = 1; i < driven_.moments.size(); ++i) {
      const Moment& a = driven_.moments[i - 1];
      const Moment& b = driven_.moments[i];
      for (Steady& steady : gains_) gain(steady, b);
      while (piece + 1 < driven_.pieces.size() && driven_.begin_m[piece + 1] <= a.way_m) ++piece;
      for (std::size_t p = piece; p < driven_.pieces.size() && driven_.begin_m[p] < b.way_m; ++p)
        part(p, a, b);
    }
  }

 private:
  void say(const char* code, Point at, Measured measured, const std::string& what) {
    plan_.findings.add(code, driven_.record->block, at, measured,
                       "robot " + std::to_string(driven_.record->robot) + " " + what);
  }

  void gain(Steady& steady, const Moment& to) {
    constexpr double kSpeeds_mps = 1e-4;  // of the rounding of two speeds
    const double above = steady.above_mps(to);
    if (above > kSpeeds_mps + steady.limit_mps2 * kTime_s) tell_gain(steady, to);
    if (above < 0 || above > kSpeeds_mps + steady.limit_mps2 * kTime_s) steady.from = &to;
  }

  void tell_gain(const Steady& steady, const Moment& to) {
    const Moment& from = *steady.from;
    const double gain = (to.speed_mps - from.speed_mps) / std::max(to.t_s - from.t_s, kTime_s);
    const double limit = steady.limit_mps2 / kSlack;
    say("acceleration", driven_.spot(from.way_m).at, {gain, limit},
        (steady.sign > 0 ? "speeds up by " : "brakes by ") + shown(std::abs(gain), 3) + " m/s2 at " +
            shown(from.t_s, 1) + " s; at most " + shown(limit, 3));
  }

  /// So short that to pass over it is as good as a joint.
  [[nodiscard]] static bool is_nothing(const PieceLine& piece) {
    constexpr double kNothing_m = 1e-6;
    constexpr double kJoint_per_m = 1e-6;
    return piece.length_m() <= kNothing_m &&
           std::abs(piece.record().sharpness_per_m2) * piece.length_m() <= kJoint_per_m;
  }

  /// Where a short part lies is known as well as its samples' places: what the square of the speed changes by
  /// over as much.
  [[nodiscard]] double give_m2ps2(double long_m) const {
    constexpr double kShort_m = 1e-3;
    constexpr double kPlace_m = 3e-4;
    const Machine& m = plan_.vehicle.machine;
    return long_m < kShort_m ? 2 * std::max(m.max_accel_mps2, m.max_brake_mps2) * kPlace_m : 0;
  }

  void part(std::size_t p, const Moment& a, const Moment& b) {
    const double from = std::max(a.way_m, driven_.begin_m[p]);
    const double to = std::min(b.way_m, driven_.begin_m[p + 1]);
    if (!(to > from) || is_nothing(driven_.pieces[p])) return;
    const double give = give_m2ps2(to - from);
    const double v0 = a.speed_mps * a.speed_mps;
    const double v1 = b.speed_mps * b.speed_mps;
    const auto at = [&](double way) { return v0 + (way - a.way_m) / (b.way_m - a.way_m) * (v1 - v0); };
    const auto less = [give](double square) {
      const double speed = std::max(0.0, std::sqrt(std::max(0.0, square - give)) - kSpeed_mps);
      return speed * speed;
    };
    const PieceLine& line = driven_.pieces[p];
    check(p, {line.curve_m(from - driven_.begin_m[p]), line.curve_m(to - driven_.begin_m[p]), less(at(from)),
              less(at(to))});
  }

  void check(std::size_t p, const Part& part) {
    const PieceLine& line = driven_.pieces[p];
    const Machine& m = plan_.vehicle.machine;
    const double cap = line.record().tool == 1 ? m.work_speed_mps
                       : line.straight()       ? m.max_speed_mps
                                               : m.turn_speed_mps;
    const double top = std::sqrt(std::max(part.from_speed2, part.to_speed2));
    if (top > cap * kSlack)
      say("speed", line.spot(part.from_m).at, {top, cap},
          "drives " + piece_name(driven_, p) + " at " + shown(top, 3) + " m/s; at most " + shown(cap, 3));
    if (line.straight()) return;
    lateral(p, part);
    steering(p, part);
  }

  /// v^2 |k|, of which v^2 and k are linear in the way: a parabola.
  void lateral(std::size_t p, const Part& part) {
    const PieceLine& line = driven_.pieces[p];
    const double limit = plan_.vehicle.machine.max_lateral_mps2;
    const double from = line.curvature_per_m(part.from_m);
    const double to = line.curvature_per_m(part.to_m);
    const double top2 = std::max(part.from_speed2, part.to_speed2);
    if (top2 * std::max(std::abs(from), std::abs(to)) <= limit * kSlack) return;
    const auto bent = [&](double s) { return part.speed2(s) * std::abs(line.curvature_per_m(s)); };
    const double flat =  // where the curve changes sides there is a peak on each
        from * to < 0 ? part.from_m + from / (from - to) * (part.to_m - part.from_m) : part.to_m;
    const double most = std::max(largest(part.from_m, flat, bent), largest(flat, part.to_m, bent));
    if (most <= limit * kSlack) return;
    say("lateral", line.spot(part.from_m).at, {most, limit},
        "drives " + piece_name(driven_, p) + " with " + shown(most, 3) + " m/s2 to the side; at most " +
            shown(limit, 3));
  }

  /// No steering along the part is faster: its highest speed, and no thanks to curvature.
  [[nodiscard]] double bound(const PieceLine& line, const Part& part) const {
    if (line.record().offset_m != 0) return 2 * plan_.vehicle.most_steering_rad_s;
    const double top2 = std::max(part.from_speed2, part.to_speed2);
    return steering_rad_s(plan_.vehicle, 0, line.record().sharpness_per_m2, std::sqrt(top2));
  }

  /// The square of the speed less that at which the steering is as fast as it can: concave along the piece.
  void steering(std::size_t p, const Part& part) {
    const PieceLine& line = driven_.pieces[p];
    const double limit = plan_.vehicle.most_steering_rad_s;
    const double offset = line.record().offset_m;
    if (line.record().sharpness_per_m2 == 0) return;
    const auto rate = [&](double s) {
      const double k = line.curvature_per_m(s);
      const double shrunk = 1 + offset * k;  // 1 / (1 - d k of the curve)
      return steering_rad_s(plan_.vehicle, k, line.record().sharpness_per_m2 * shrunk * shrunk * shrunk,
                            std::sqrt(part.speed2(s)));
    };
    if (bound(line, part) <= limit * kSlack) return;
    const double most = largest(part.from_m, part.to_m, rate);
    if (most <= limit * kSlack) return;
    say("steering_rate", line.spot(part.from_m).at, {most, limit},
        "steers by " + shown(most, 4) + " rad/s in " + piece_name(driven_, p) + "; at most " +
            shown(limit, 4));
  }

  Case& plan_;
  const Driven& driven_;
  std::array<Steady, 2> gains_;
};

}  // namespace

void check_speeds(Case& plan, const Driven& driven) { SpeedCheck{plan, driven}.run(); }

}  // namespace selion::verifying
