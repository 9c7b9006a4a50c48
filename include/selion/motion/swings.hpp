// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "selion/core/point.hpp"

namespace selion {

struct CurveLimits {
  double curvature_per_m = 0;
  double sharpness_per_m2 = 0;

  friend bool operator==(const CurveLimits&, const CurveLimits&) = default;
};

/// Of the same curves `by` times as large.
constexpr CurveLimits widened(const CurveLimits& limits, double by) {
  return {limits.curvature_per_m / by, limits.sharpness_per_m2 / (by * by)};
}

/// The curves of a swing by a deflection >= 0: clothoid, arc, clothoid.
struct SwingShape {
  double curvature_per_m = 0;  ///< at its middle
  double sharpness_per_m2 = 0;
  double clothoid_m = 0;  ///< length of each
  double arc_m = 0;
};

/// Straight from a swing's start to its end. Its direction is half of the deflection.
struct Chord {
  double length_m = 0;         ///< negative where a swing turns so far that its ends have passed each other
  double slope_m_per_rad = 0;  ///< with respect to the deflection
};

/// All swings within some limits: turns that start and end straight (clothoid, arc, clothoid). What they move
/// depends on their deflection only, so it is worked out once for all turns of a machine.
class Swings {
 public:
  /// Parts of a whole turn in the table of two_swings().
  static constexpr std::size_t kParts = 12;

  /// Both limits above 0.
  explicit Swings(const CurveLimits& limits);

  [[nodiscard]] const CurveLimits& limits() const { return limits_; }
  /// The centre of the arc, from the start of a swing to the left: ahead and to the left. Of every swing by
  /// full_rad or more.
  [[nodiscard]] Point centre() const { return centre_; }
  /// The distance to it, and the direction that it leans by from straight left, to the right.
  [[nodiscard]] double reach_m() const { return reach_m_; }
  [[nodiscard]] double lean_rad() const { return lean_rad_; }
  /// The least deflection at which the curvature limit is reached.
  [[nodiscard]] double full_rad() const { return full_rad_; }
  /// unit(full_rad() / 2).
  [[nodiscard]] Point full_half() const { return full_half_; }

  /// @pre 0 <= deflection_rad < 2 pi for these.
  [[nodiscard]] SwingShape shape(double deflection_rad) const;
  [[nodiscard]] double length_m(double deflection_rad) const;
  [[nodiscard]] Chord chord(double deflection_rad) const;
  /// The same for callers that have the chord's direction, unit(deflection_rad / 2), at hand.
  [[nodiscard]] Chord chord(double deflection_rad, Point direction) const;
  /// How far the middle of the swing stands off its chord, outwards.
  [[nodiscard]] double bulge_m(double deflection_rad) const;
  /// From the start of a clothoid that grows from curvature 0 to its end, in the frame of the end, for a turn
  /// to the left of `deflection_rad` over `length_m` (y negative: the start lies to the left).
  [[nodiscard]] static Point ramp(double deflection_rad, double length_m);
  /// The ramp to the curvature limit.
  [[nodiscard]] Point full_ramp() const { return full_ramp_; }
  /// Where a swing left by `left` parts of a whole turn and one right by `right` parts lead.
  [[nodiscard]] Point two_swings(std::size_t left, std::size_t right) const {
    return two_swings_[left][right];
  }

 private:
  CurveLimits limits_;
  double full_rad_ = 0;
  Point full_half_;
  Point full_ramp_;
  Point centre_;
  double reach_m_ = 0;
  double lean_rad_ = 0;
  std::array<std::array<Point, kParts + 1>, kParts + 1> two_swings_{};
};

}  // namespace selion
