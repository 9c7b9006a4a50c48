// SPDX-License-Identifier: GPL-3.0-or-later
#include "driven.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace selion::verifying {
namespace {

constexpr double kTurned_rad = 0.25;  // at most over a step: five nodes then err by less than a nanometre
constexpr auto kNodes = std::to_array<std::pair<double, double>>({{-0.9061798459386640, 0.2369268850561891},
                                                                  {-0.5384693101056831, 0.4786286704993665},
                                                                  {0.0, 0.5688888888888889},
                                                                  {0.5384693101056831, 0.4786286704993665},
                                                                  {0.9061798459386640, 0.2369268850561891}});
constexpr int kMostSteps = 100'000;

}  // namespace

PieceLine::PieceLine(const PieceRecord& record) : record_{&record}, ahead_{unit(record.heading_rad)} {
  const double length = record.length_m;
  const double turned =
      (std::abs(record.curvature_per_m) + std::abs(record.sharpness_per_m2) * length) * length;
  const int steps =
      straight() ? 1 : static_cast<int>(std::clamp(std::ceil(turned / kTurned_rad), 1.0, 1.0 * kMostSteps));
  step_m_ = length / steps;
  knots_.reserve(static_cast<std::size_t>(steps) + 1);
  knots_.push_back({record.x_m, record.y_m});
  for (int i = 0; i < steps; ++i) knots_.push_back(from(knots_.back(), i * step_m_, (i + 1) * step_m_));
}

double PieceLine::angle(double s_m) const {
  return record_->heading_rad + (record_->curvature_per_m + record_->sharpness_per_m2 * s_m / 2) * s_m;
}

Point PieceLine::from(Point at, double from_m, double to_m) const {
  if (from_m == to_m) return at;
  if (straight()) return at + (to_m - from_m) * ahead_;
  const double half = (to_m - from_m) / 2;
  for (const auto& [node, weight] : kNodes) at = at + half * weight * unit(angle(from_m + half * (1 + node)));
  return at;
}

Spot PieceLine::spot(double s_m) const {
  const double share = step_m_ > 0 ? s_m / step_m_ : 0;
  const auto knot = static_cast<std::size_t>(std::clamp(share, 0.0, static_cast<double>(knots_.size()) - 2));
  const double heading = angle(s_m);
  const double off = record_->offset_m;
  const Point at =
      s_m == length_m() ? knots_.back() : from(knots_[knot], static_cast<double>(knot) * step_m_, s_m);
  return {off == 0 ? at : at + off * left_of(unit(heading)), heading, curvature_per_m(s_m)};
}

double PieceLine::curvature_per_m(double s_m) const {
  const double k = record_->curvature_per_m + record_->sharpness_per_m2 * s_m;
  return k / (1 - record_->offset_m * k);
}

double PieceLine::vehicle_heading_rad(double s_m) const {
  return angle(s_m) + (record_->gear < 0 ? std::numbers::pi : 0);
}

Pose PieceLine::vehicle(double s_m) const { return {spot(s_m).at, vehicle_heading_rad(s_m)}; }

double PieceLine::most_curvature_per_m() const {
  return std::max(std::abs(curvature_per_m(0)), std::abs(curvature_per_m(length_m())));
}

double PieceLine::driven_m(double s_m) const {
  return s_m - record_->offset_m * (angle(s_m) - record_->heading_rad);
}

double PieceLine::curve_m(double driven_m) const {
  if (record_->offset_m == 0) return driven_m;
  constexpr double kClose_m = 1e-9;  // Newton's next step is the square of this one
  double s = driven_m;
  double step = 2 * kClose_m;
  for (int i = 0; i < 20 && !(std::abs(step) < kClose_m); ++i) {
    const double k = record_->curvature_per_m + record_->sharpness_per_m2 * s;
    step = (this->driven_m(s) - driven_m) / (1 - record_->offset_m * k);
    s -= step;
  }
  return s;
}

Stop Driven::stop(double way_m) const {
  const auto after = std::upper_bound(begin_m.begin(), begin_m.end() - 1, way_m);
  auto piece = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - begin_m.begin() - 1));
  while (piece > 0 && !(pieces[piece].length_m() > 0)) --piece;
  const double on_m = std::clamp(way_m - begin_m[piece], 0.0, begin_m[piece + 1] - begin_m[piece]);
  return {piece, std::clamp(pieces[piece].curve_m(on_m), 0.0, pieces[piece].length_m())};
}

Spot Driven::spot(double way_m) const {
  const Stop here = stop(way_m);
  return pieces[here.piece].spot(here.s_m);
}

Driven driven_of(const TrajectoryRecord& record) {
  Driven driven;
  driven.record = &record;
  driven.pieces.reserve(record.pieces.size());
  driven.begin_m.push_back(0);
  for (const PieceRecord& piece : record.pieces) {
    const PieceLine& line = driven.pieces.emplace_back(piece);
    driven.begin_m.push_back(driven.begin_m.back() + line.driven_m(line.length_m()));
  }
  return driven;
}

double time_s(const Driven& driven, double way_m) {
  const auto& moments = driven.moments;
  const auto after =
      std::partition_point(moments.begin(), moments.end(), [&](const Moment& m) { return m.way_m < way_m; });
  if (after == moments.begin()) return moments.front().t_s;
  if (after == moments.end()) return moments.back().t_s;
  const Moment& a = *(after - 1);
  const double share = (way_m - a.way_m) / (after->way_m - a.way_m);
  const double span = after->t_s - a.t_s;
  const double gain = after->speed_mps - a.speed_mps;
  const double speed2 = a.speed_mps * a.speed_mps + share * gain * (a.speed_mps + after->speed_mps);
  const double mean = (a.speed_mps + std::sqrt(std::max(0.0, speed2))) / 2;
  return a.t_s + (mean > 0 ? std::min(1.0, share * (a.speed_mps + after->speed_mps) / 2 / mean) * span : 0);
}

double departure_s(const Driven& driven, double way_m) {
  constexpr double kNear_m = 1e-3;  // of a place: the sample stands there
  const auto past = std::ranges::upper_bound(driven.moments, way_m + kNear_m, {}, &Moment::way_m);
  return past == driven.moments.begin() ? past->t_s : (past - 1)->t_s;
}

double way_m(const Driven& driven, double t_s) {
  const auto& moments = driven.moments;
  const auto after =
      std::partition_point(moments.begin(), moments.end(), [&](const Moment& m) { return m.t_s <= t_s; });
  if (after == moments.begin()) return moments.front().way_m;
  if (after == moments.end()) return moments.back().way_m;
  const Moment& a = *(after - 1);
  const double share = (t_s - a.t_s) / (after->t_s - a.t_s);
  const double sum = a.speed_mps + after->speed_mps;
  if (!(sum > 0)) return a.way_m;
  const double done = share * (2 * a.speed_mps + share * (after->speed_mps - a.speed_mps)) / sum;
  return a.way_m + done * (after->way_m - a.way_m);
}

}  // namespace selion::verifying
