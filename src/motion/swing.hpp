// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/turns.hpp"

namespace selion {

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

/// All swings within some limits. What they move depends on their deflection only, so it is worked out once.
class Swings {
 public:
  explicit Swings(const CurveLimits& limits);

  [[nodiscard]] const CurveLimits& limits() const { return limits_; }
  /// The centre of the arc, from the start of a swing to the left: ahead and to the left. Of every swing by
  /// full_rad or more.
  [[nodiscard]] Point centre() const { return centre_; }
  /// The least deflection at which the curvature limit is reached.
  [[nodiscard]] double full_rad() const { return full_rad_; }

  /// @pre 0 <= deflection_rad < 2 pi for the four.
  [[nodiscard]] SwingShape shape(double deflection_rad) const;
  [[nodiscard]] Chord chord(double deflection_rad) const;
  /// The same for callers that have the chord's direction, unit(deflection_rad / 2), at hand.
  [[nodiscard]] Chord chord(double deflection_rad, Point direction) const;
  /// How far the middle of the swing stands off its chord, outwards.
  [[nodiscard]] double bulge_m(double deflection_rad) const;

 private:
  CurveLimits limits_;
  double full_rad_ = 0;
  Point centre_;
};

/// A path while it is drawn, curve by curve, and where it has come to.
struct Drawn {
  Path path;
  Pose at;
};
void draw(Drawn& drawn, double curvature_per_m, double sharpness_per_m2, double length_m);
/// Nothing where `length_m` is not above 0.
void draw_line(Drawn& drawn, double length_m);
/// Nothing where `deflection_rad` is 0.
void draw_swing(Drawn& drawn, double deflection_rad, const Swings& swings);

}  // namespace selion
