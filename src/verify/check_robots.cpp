// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "check.hpp"
#include "segments.hpp"

namespace selion::verifying {
namespace {

/// Where the robot is at some time, on the spot turned as far as it is by then.
Pose pose_at(const Driven& driven, double t_s) {
  const Stop here = driven.stop(way_m(driven, t_s));
  Pose pose = driven.pieces[here.piece].vehicle(here.s_m);
  const auto after = std::ranges::upper_bound(driven.moments, t_s, {}, &Moment::t_s);
  if (after == driven.moments.begin() || after == driven.moments.end()) return pose;
  const Moment& before = *(after - 1);
  if (before.spin_rad_s == 0 && after->spin_rad_s == 0) return pose;
  const double span = t_s - before.t_s;
  const double gain = (after->spin_rad_s - before.spin_rad_s) / (after->t_s - before.t_s);
  pose.heading_rad = before.heading_rad + (before.spin_rad_s + gain * span / 2) * span;
  return pose;
}

class RobotCheck {
 public:
  explicit RobotCheck(Case& plan) : plan_{plan} {
    const Machine& m = plan.vehicle.machine;
    const double half = m.body_width_m / 2;
    const double wide = m.working_width_m / 2;
    parts_ = {Corners{Point{-m.rear_m, -half}, {m.front_m, -half}, {m.front_m, half}, {-m.rear_m, half}},
              Corners{Point{m.tool_x_m, -wide}, {m.tool_x_m, -wide}, {m.tool_x_m, wide}, {m.tool_x_m, wide}}};
    for (const Corners& part : parts_)
      for (const Point corner : part) reach_m_ = std::max(reach_m_, length_m(corner));
  }

  void run() {
    for (std::size_t i = 0; i < plan_.drives.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Driven& a = plan_.drives[i];
        const Driven& b = plan_.drives[k];
        if (a.record->robot == b.record->robot || a.moments.empty() || b.moments.empty()) continue;
        const double end = std::max(a.moments.back().t_s, b.moments.back().t_s);
        pair(a, b, 0, end);
      }
  }

 private:
  /// Body and tool line, raised or not, each as corners.
  using Outline = std::array<Corners, 2>;
  [[nodiscard]] Outline placed_parts(const Pose& pose) const {
    Outline outline = parts_;
    for (Corners& part : outline)
      for (Point& corner : part) corner = placed(pose, corner);
    return outline;
  }

  static double apart_m(const Outline& a, const Outline& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Corners& one : a)
      for (const Corners& other : b) least = std::min(least, verifying::distance_m(one, other));
    return least;
  }

  static constexpr double kFine_m = 0.005;

  /// Robots that touch are too close even where no gap is asked for.
  [[nodiscard]] double gap_m() const { return std::max(plan_.vehicle.machine.safety_gap_m, 2 * kFine_m); }

  /// What no place of the robot moves farther than.
  [[nodiscard]] double moved_m(const Driven& driven, double from_s, double to_s) const {
    const double way = way_m(driven, to_s) - way_m(driven, from_s);
    return way * (1 + plan_.vehicle.most_curvature_per_m * reach_m_) +
           spun_rad(driven, from_s, to_s) * reach_m_;
  }

  /// How far it turns on the spot then, or farther.
  [[nodiscard]] double spun_rad(const Driven& driven, double from_s, double to_s) const {
    const Machine& m = plan_.vehicle.machine;
    if (!m.may_pivot) return 0;
    auto moment = std::ranges::upper_bound(driven.moments, from_s, {}, &Moment::t_s);
    if (moment != driven.moments.begin()) --moment;
    for (; moment != driven.moments.end(); ++moment) {
      if (moment->spin_rad_s != 0) return 2 * m.turn_speed_mps / m.track_m * (to_s - from_s);
      if (moment->t_s > to_s) break;
    }
    return 0;
  }

  /// Halves the time until both are certainly far enough from each other, or are not.
  bool pair(const Driven& a, const Driven& b, double from_s, double to_s) {
    const double gap = gap_m();
    const double middle = (from_s + to_s) / 2;
    const auto most = [&](const Driven& driven) {
      return std::max(moved_m(driven, from_s, middle), moved_m(driven, middle, to_s));
    };
    const double moved = most(a) + most(b);
    const Pose pose_a = pose_at(a, middle);
    const Pose pose_b = pose_at(b, middle);
    if (distance_m(pose_a.at, pose_b.at) - 2 * reach_m_ > gap + moved) return false;
    const double apart = apart_m(placed_parts(pose_a), placed_parts(pose_b));
    if (apart > gap + moved) return false;
    if (apart < gap - kFine_m || moved < kFine_m) {
      if (apart >= gap - kFine_m) return false;
      tell(a, b, pose_a, middle, apart);
      return true;
    }
    return pair(a, b, from_s, middle) || pair(a, b, middle, to_s);
  }

  void tell(const Driven& a, const Driven& b, const Pose& pose, double t_s, double apart) {
    const double gap = gap_m();
    plan_.findings.add("robots_too_close", a.record->block, pose.at, {apart, gap},
                       "robots " + std::to_string(b.record->robot) + " and " +
                           std::to_string(a.record->robot) + " come within " + shown(apart, 3) +
                           " m of each other at " + shown(t_s, 1) + " s; at least " + shown(gap, 3) +
                           " m are asked for");
  }

  Case& plan_;
  Outline parts_;
  double reach_m_ = 0;
};

}  // namespace

void check_robots(Case& plan) { RobotCheck{plan}.run(); }

}  // namespace selion::verifying
