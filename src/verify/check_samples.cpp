// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kPlace_m = 1.2e-3;  // a millimetre, and the coordinates' rounding
constexpr double kWay_m = 6e-4;      // of the rounding of two places and of speeds
constexpr double kSpeed_mps = 1e-4;  // of a speed's and a time's rounding
constexpr double kSettled_m = 1e-9;  // a step as short changes nothing any more
constexpr double kNear_m = 1e-3;     // of a joint: the sample may belong to either side
constexpr double kTurn = 2 * std::numbers::pi;

/// Way driven beyond what speeds and times give, seen from the sample where it was least: between some sample
/// and a later one it is too much if it is from that one, so roundings do not add up over many.
struct Lead {
  double sign;  ///< -1: of way that is missing
  std::size_t from = 0;
  double least_m = 0;
};

/// Walks along the samples of one trajectory.
class SampleCheck {
 public:
  SampleCheck(Case& plan, Driven& driven)
      : plan_{plan}, driven_{driven}, record_{*driven.record}, at_{plan.plane.to_local(record_.line)} {}

  void run() {
    if (record_.line.size() < 2) return;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      place(i);
      heading(i);
      curvature(i);
      if (i > 0) interval(i);
    }
    ends();
  }

 private:
  void say(const char* code, std::size_t i, Measured measured, const std::string& what) {
    plan_.findings.add(code, record_.block, at_[i], measured,
                       "robot " + std::to_string(record_.robot) + ", sample " + std::to_string(i + 1) + " (" +
                           shown(record_.t_s[i], 1) + " s) " + what);
  }

  [[nodiscard]] double speed(std::size_t i) const { return std::abs(record_.speed_mps[i]); }

  /// Where speeds lead from the sample before, corrected by where the sample lies.
  void place(std::size_t i) {
    double way = 0;
    double reach = kNear_m;
    if (i > 0) {
      const double span = record_.t_s[i] - record_.t_s[i - 1];
      reach += kSpeed_mps / 2 * std::max(0.0, span);  // what a speed's rounding adds up to
      way = driven_.moments.back().way_m + (speed(i - 1) + speed(i)) / 2 * span;
    }
    const double led = std::clamp(way, 0.0, driven_.whole_m());
    way = led;
    Spot here = driven_.spot(way);
    for (int k = 0; k < 3; ++k) {
      const double before = way;
      way = std::clamp(way + dot(at_[i] - here.at, unit(here.heading_rad)), led - reach, led + reach);
      way = std::clamp(way, 0.0, driven_.whole_m());
      if (std::abs(way - before) < kSettled_m) break;
      here = driven_.spot(way);
    }
    const double off = distance_m(here.at, at_[i]);
    if (!(off <= kPlace_m)) {
      say("sample_place", i, {off, 1e-3},
          "lies " + shown(off, 4) + " m off where its pieces and speeds lead");
      if (!plan_.findings.full("sample_place", record_.block)) way = nearest(i, led);
    }
    driven_.moments.push_back({record_.t_s[i], speed(i), snapped(way), record_.heading_rad[i], 0});
    if (i > 0) spin(driven_.moments[i - 1], driven_.moments[i]);
  }

  /// From rest on, what turns it so far in that time.
  static void spin(const Moment& before, Moment& now) {
    const double span = now.t_s - before.t_s;
    if (now.way_m - before.way_m > kNear_m / 2 || !(span > 0)) return;
    now.spin_rad_s =
        2 * std::remainder(now.heading_rad - before.heading_rad, kTurn) / span - before.spin_rad_s;
  }

  /// A sample stands at each joint: one as near as roundings is there.
  [[nodiscard]] double snapped(double way) const {
    constexpr double kRounded_m = 2e-4;
    const auto next = std::lower_bound(driven_.begin_m.begin(), driven_.begin_m.end(), way);
    if (next != driven_.begin_m.end() && *next - way < kRounded_m) return *next;
    if (next != driven_.begin_m.begin() && way - *(next - 1) < kRounded_m) return *(next - 1);
    return way;
  }

  /// Where the sample is nearest to the pieces, within some metres, so that one that is off does not take
  /// those after it along.
  [[nodiscard]] double nearest(std::size_t i, double led) const {
    constexpr double kStep_m = 0.05;
    constexpr int kSteps = 100;
    double best = led;
    double least = distance_m(driven_.spot(led).at, at_[i]);
    for (int k = -kSteps; k <= kSteps; ++k) {
      const double way = std::clamp(led + k * kStep_m, 0.0, driven_.whole_m());
      const double off = distance_m(driven_.spot(way).at, at_[i]);
      if (off < least) best = way, least = off;
    }
    return best;
  }

  /// Pieces that touch the sample's place, those that stand among them.
  template <class Fits>
  [[nodiscard]] bool of_some_piece(std::size_t i, Fits fits) const {
    const double way = driven_.moments[i].way_m;
    const auto& begin = driven_.begin_m;
    auto piece =
        static_cast<std::size_t>(std::lower_bound(begin.begin(), begin.end(), way - kNear_m) - begin.begin());
    piece = piece == 0 ? 0 : piece - 1;
    for (; piece < driven_.pieces.size() && begin[piece] <= way + kNear_m; ++piece) {
      const PieceLine& line = driven_.pieces[piece];
      const double on = std::clamp(way - begin[piece], 0.0, begin[piece + 1] - begin[piece]);
      if (fits(line, std::clamp(line.curve_m(on), 0.0, line.length_m()))) return true;
    }
    return false;
  }

  void heading(std::size_t i) {
    constexpr double kHeading_rad = 2e-6;
    const bool fits = of_some_piece(i, [&](const PieceLine& line, double s) {
      const double slack = kHeading_rad + line.most_curvature_per_m() * kNear_m;
      const double off = std::remainder(record_.heading_rad[i] - line.vehicle_heading_rad(s), kTurn);
      const double pivot = line.record().angle_rad.value_or(0);
      return off >= std::min(0.0, pivot) - slack && off <= std::max(0.0, pivot) + slack;
    });
    if (fits) return;
    const double points = driven_.pieces[driven_.stop(driven_.moments[i].way_m).piece].vehicle(0).heading_rad;
    say("sample_heading", i, {std::remainder(record_.heading_rad[i] - points, kTurn), kHeading_rad},
        "points another way than its piece");
  }

  void curvature(std::size_t i) {
    constexpr double kCurvature_per_m = 2e-6;
    const double given = record_.curvature_per_m[i];
    const bool fits = of_some_piece(i, [&](const PieceLine& line, double s) {
      const double slack = kCurvature_per_m + std::abs(line.record().sharpness_per_m2) * kNear_m;
      return std::abs(line.curvature_per_m(s) - given) <= slack;
    });
    if (fits) return;
    const double bends = driven_.spot(driven_.moments[i].way_m).curvature_per_m;
    say("sample_curvature", i, {given, bends},
        "has the curvature " + shown(given, 6) + " 1/m, its piece " + shown(bends, 6));
  }

  void interval(std::size_t i) {
    const double span = record_.t_s[i] - record_.t_s[i - 1];
    if (!(span > 0)) say("time_order", i, {span, 0}, "is not later than the one before");
    const Moment& a = driven_.moments[i - 1];
    const Moment& b = driven_.moments[i];
    const double way = b.way_m - a.way_m;
    told_m_ += (a.speed_mps + b.speed_mps) / 2 * span;
    rounded_m_ += kSpeed_mps * (span + std::abs(b.speed_mps - a.speed_mps));
    for (Lead& lead : leads_) agrees(i, lead);
    if (way <= 2 * kNear_m) return near(i, span);
    const Stop middle = driven_.stop((a.way_m + b.way_m) / 2);
    const PieceLine& piece = driven_.pieces[middle.piece];
    if (record_.tool[i - 1] != piece.record().tool)
      say("sample_tool", i - 1, {1.0 * record_.tool[i - 1], 1.0 * piece.record().tool},
          "has another tool state than its piece");
    gear(i, piece.record().gear);
    const double most = piece.straight() ? 100.01 : 0.251;
    if (way > most && driven_.stop(a.way_m + kNear_m).piece == driven_.stop(b.way_m - kNear_m).piece)
      say("sample_gap", i, {way, most}, "is " + shown(way, 2) + " m after the one before");
  }

  /// Way by place against way by speeds and times.
  void agrees(std::size_t i, Lead& lead) {
    const double ahead = lead.sign * (driven_.moments[i].way_m - told_m_) - rounded_m_;
    const Moment& from = driven_.moments[lead.from];
    const double slack = kWay_m + kSpeed_mps * (from.speed_mps + driven_.moments[i].speed_mps);
    const double off = ahead - lead.least_m;
    if (!(off <= slack)) {
      const double way = driven_.moments[i].way_m - from.way_m;
      const double told = way - lead.sign * off;
      say("sample_speed", i, {told, way},
          "is " + shown(way, 4) + " m after sample " + std::to_string(lead.from + 1) +
              "; speeds and times give " + shown(told, 4) + " m");
    }
    if (!(off >= 0 && off <= slack)) lead.from = i, lead.least_m = ahead;
  }

  /// Hardly farther than the sample before: it rests, or is driven as one of the pieces there.
  void near(std::size_t i, double span) {
    if (speed(i - 1) <= kSpeed_mps && speed(i) <= kSpeed_mps) return idle(i, span);
    const auto some = [&](auto fits) { return of_some_piece(i - 1, fits) || of_some_piece(i, fits); };
    const int tool = record_.tool[i - 1];
    if (!some([tool](const PieceLine& line, double) { return line.record().tool == tool; }))
      say("sample_tool", i - 1, {1.0 * tool, 1.0 * (1 - tool)}, "has another tool state than its piece");
    const int gear = record_.speed_mps[speed(i) > kSpeed_mps ? i : i - 1] > 0 ? 1 : -1;
    if (!some([gear](const PieceLine& line, double) { return line.record().gear == gear; }))
      this->gear(i, -gear);
  }

  /// It rests where a piece waits or pivots, and there only; with the tool as that piece has it.
  void idle(std::size_t i, double span) {
    if (!(span > 2e-3)) return;
    const auto stands_with = [](int tool) {
      return [tool](const PieceLine& line, double) { return line.stands() && line.record().tool == tool; };
    };
    if (of_some_piece(i, stands_with(record_.tool[i - 1]))) return;
    if (of_some_piece(i, stands_with(1 - record_.tool[i - 1])))
      return say("sample_tool", i - 1, {1.0 * record_.tool[i - 1], 1.0 * (1 - record_.tool[i - 1])},
                 "has another tool state than its piece");
    say("rest", i, {span, 0}, "ends a rest of " + shown(span, 2) + " s where no piece stands");
  }

  void gear(std::size_t i, int gear) {
    for (const std::size_t k : {i - 1, i})
      if (speed(k) > kSpeed_mps && (record_.speed_mps[k] > 0) != (gear > 0))
        say("sample_gear", k, {record_.speed_mps[k], 0.0}, "is driven in another gear than its piece");
  }

  void ends() {
    const std::size_t last = at_.size() - 1;
    const double left = driven_.whole_m() - driven_.moments.back().way_m;
    if (!(std::abs(left) <= kNear_m))
      say("not_finished", last, {left, 0}, "is the last one, " + shown(left, 3) + " m before the end");
    if (speed(0) > kSpeed_mps || speed(last) > kSpeed_mps || record_.t_s[0] != 0)
      say("not_finished", last, {std::max(speed(0), speed(last)), 0},
          "does not end, or the first one not begin, at rest and at 0 s");
    const double length = record_.length_m - driven_.whole_m();
    if (!(std::abs(length) <= kNear_m))
      say("length", last, {record_.length_m, driven_.whole_m()},
          "ends a trajectory said to be " + shown(record_.length_m, 2) + " m long; its pieces are " +
              shown(driven_.whole_m(), 2) + " m");
    if (!(std::abs(record_.duration_s - record_.t_s[last]) <= 2e-4))
      say("duration", last, {record_.duration_s, record_.t_s[last]},
          "ends a trajectory said to take " + shown(record_.duration_s, 2) + " s");
  }

  Case& plan_;
  Driven& driven_;
  const TrajectoryRecord& record_;
  std::vector<Point> at_;
  double told_m_ = 0;     ///< way by speeds and times, since the first sample
  double rounded_m_ = 0;  ///< what their roundings add up to
  std::array<Lead, 2> leads_{Lead{1}, Lead{-1}};
};

}  // namespace

void check_samples(Case& plan, Driven& driven) { SampleCheck{plan, driven}.run(); }

}  // namespace selion::verifying
