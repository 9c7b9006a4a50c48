// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "selion/motion/nearest.hpp"

namespace selion {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

void include(Box& box, Point p) {
  box.low = {std::min(box.low.x_m, p.x_m), std::min(box.low.y_m, p.y_m)};
  box.high = {std::max(box.high.x_m, p.x_m), std::max(box.high.y_m, p.y_m)};
}

/// How far the heading turns, either way, until it next crosses an axis.
double to_axis(double heading, bool to_left) {
  const double quarters = heading / kQuarter;
  return kQuarter * (to_left ? std::floor(quarters) + 1 - quarters : quarters - std::ceil(quarters) + 1);
}

/// The places where the heading crosses an axis, within the first turn from `from` towards `to`, over which
/// the curvature grows by size: beyond, the curve stays within that turn.
void include_turn(Box& box, const Curve& curve, double from, double to) {
  const CurveState state = state_at(curve, from);
  include(box, state.at);
  const double sense = to < from ? -1 : 1;
  // At the turning point the curvature's own sign is rounding.
  const double last = sense * (curve.curvature_per_m + curve.sharpness_per_m2 * to);
  if (last == 0) return;
  const double k = std::abs(state.curvature_per_m);
  const double c = std::abs(curve.sharpness_per_m2);
  const double first = to_axis(state.heading_rad, last > 0);
  for (int i = 0; i < 5; ++i) {
    const double turn = first + i * kQuarter;
    const double way = 2 * turn / (k + std::sqrt(k * k + 2 * c * turn));
    if (way >= std::abs(to - from)) return;
    include(box, state_at(curve, from + sense * way).at);
  }
}

}  // namespace

Box box_of(const Curve& curve) {
  Box box{curve.start, curve.start};
  const double end = curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m;
  include(box, end_of(curve).at);
  if ((curve.curvature_per_m > 0 && end < 0) || (curve.curvature_per_m < 0 && end > 0)) {
    const double straight = -curve.curvature_per_m / curve.sharpness_per_m2;
    include_turn(box, curve, straight, 0);
    include_turn(box, curve, straight, curve.length_m);
  } else if (std::abs(curve.curvature_per_m) <= std::abs(end)) {
    include_turn(box, curve, 0, curve.length_m);
  } else {
    include_turn(box, curve, curve.length_m, 0);
  }
  return box;
}

std::optional<Box> box_of(const Path& path) {
  if (path.empty()) return std::nullopt;
  Box box = box_of(path.front().curve);
  for (const Stretch& stretch : path) {
    const Box more = box_of(stretch.curve);
    include(box, more.low);
    include(box, more.high);
  }
  return box;
}

}  // namespace selion
