// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "selion/motion/path.hpp"
#include "swing.hpp"

namespace selion {

/// The longest step along the curve from whose chord a point of the body, `reach_m` from the axle, strays by
/// at most `stray_m`: by the largest second derivative of its way, k + k^2 r, and r times the sharpness.
inline double chord_m(const Curve& curve, double reach_m, double stray_m) {
  const double k = std::max(std::abs(curve.curvature_per_m),
                            std::abs(curve.curvature_per_m + curve.sharpness_per_m2 * curve.length_m));
  const double bend_per_m = k * (1 + k * reach_m) + std::abs(curve.sharpness_per_m2) * reach_m;
  return std::sqrt(8 * stray_m / bend_per_m);
}

using Corners = std::array<Point, 4>;

/// A pose with its direction worked out.
struct Stand {
  Stand() = default;
  explicit Stand(const Pose& pose) : at{pose.at}, ahead{unit(pose.heading_rad)} {}
  Stand(Point place, Point direction) : at{place}, ahead{direction} {}
  [[nodiscard]] Point operator()(double x_m, double y_m) const {
    return at + x_m * ahead + y_m * left_of(ahead);
  }
  Point at;
  Point ahead;
};

/// What a line across the vehicle at x, `half` to either side, sweeps between two stands close together; its
/// inner end may go back, then the corners cross over.
inline Corners swept_across(const Stand& a, const Stand& b, double x_m, double half_m) {
  return {a(x_m, -half_m), b(x_m, -half_m), b(x_m, half_m), a(x_m, half_m)};
}

inline bool turns_left(const Corners& c) {
  for (std::size_t i = 0; i < c.size(); ++i)
    if (cross(c[(i + 1) % 4] - c[i], c[(i + 2) % 4] - c[(i + 1) % 4]) <= 0) return false;
  return true;
}

/// Stands along a stretch, step by step: by Simpson's rule from one to the next, which over a step of at most
/// half a metre errs by less than a micrometre. From half step to half step the heading grows by what itself
/// grows evenly, so directions are products instead of sines and cosines.
class Walk {
 public:
  Walk(const Stretch& stretch, int steps)
      : gear_{static_cast<double>(stretch.gear)},
        step_m_{stretch.curve.length_m / steps},
        at_{stretch.curve.start},
        along_{unit(stretch.curve.heading_rad)} {
    const double half_m = step_m_ / 2;
    const double bend = stretch.curve.sharpness_per_m2 * half_m * half_m;
    turn_ = unit(stretch.curve.curvature_per_m * half_m + bend / 2);
    more_ = unit(bend);
  }

  [[nodiscard]] Stand here() const { return {at_, gear_ * along_}; }

  void advance() {
    const Point middle = next(along_);
    const Point end = next(middle);
    at_ = at_ + (step_m_ / 6) * (along_ + 4.0 * middle + end);
    along_ = end;
  }

 private:
  Point next(Point direction) {
    const Point ahead = turned(direction, turn_);
    turn_ = turned(turn_, more_);
    return ahead;
  }

  double gear_;
  double step_m_;
  Point at_;
  Point along_;
  Point turn_;  ///< by the next half step
  Point more_;  ///< what that turn grows by
};

}  // namespace selion
