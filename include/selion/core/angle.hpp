// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace selion {

/// `angle_rad` brought into (-pi, pi].
double wrapped(double angle_rad);

/// The direction of a ray: anticlockwise from east, modulo 2 pi. Only here is the compass known.
class Heading {
 public:
  static Heading radians(double anticlockwise_from_east_rad);
  /// Clockwise from north, in degrees; any finite number.
  static Heading bearing_deg(double clockwise_from_north_deg);

  /// In (-pi, pi].
  [[nodiscard]] double radians() const { return radians_; }
  /// In [0, 360).
  [[nodiscard]] double bearing_deg() const;

  friend bool operator==(const Heading&, const Heading&) = default;

 private:
  double radians_ = 0;
};

}  // namespace selion
