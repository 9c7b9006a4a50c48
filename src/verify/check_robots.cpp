// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "check.hpp"

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
    corners_ = {Point{-m.rear_m, -m.body_width_m / 2}, Point{m.front_m, -m.body_width_m / 2},
                Point{m.front_m, m.body_width_m / 2}, Point{-m.rear_m, m.body_width_m / 2}};
    reach_m_ = std::max(length_m(corners_[0]), length_m(corners_[1]));
    most_mps_ = m.max_speed_mps * (1 + plan.vehicle.most_curvature_per_m * reach_m_);
    if (m.may_pivot) most_mps_ = std::max(most_mps_, m.turn_speed_mps * 2 * reach_m_ / m.track_m);
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
  [[nodiscard]] std::array<Point, 4> body(const Pose& pose) const {
    std::array<Point, 4> body;
    for (std::size_t i = 0; i < body.size(); ++i) body[i] = placed(pose, corners_[i]);
    return body;
  }

  static constexpr double kFine_m = 0.005;

  /// Bodies that touch are too close even where no gap is asked for.
  [[nodiscard]] double gap_m() const { return std::max(plan_.vehicle.machine.safety_gap_m, 2 * kFine_m); }

  /// Halves the time until both are certainly far enough from each other, or are not.
  bool pair(const Driven& a, const Driven& b, double from_s, double to_s) {
    const double gap = gap_m();
    const double middle = (from_s + to_s) / 2;
    const double moved = 2 * most_mps_ * (to_s - from_s) / 2;
    const Pose pose_a = pose_at(a, middle);
    const Pose pose_b = pose_at(b, middle);
    if (distance_m(pose_a.at, pose_b.at) - 2 * reach_m_ > gap + moved) return false;
    const double apart = verifying::distance_m(polygon_of(body(pose_a)), polygon_of(body(pose_b)));
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
  std::array<Point, 4> corners_;
  double reach_m_ = 0;
  double most_mps_ = 0;
};

}  // namespace

void check_robots(Case& plan) { RobotCheck{plan}.run(); }

}  // namespace selion::verifying
