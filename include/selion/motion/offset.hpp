// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "selion/motion/path.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// What is driven at a constant distance beside a curve or path, left positive with respect to travel. The
/// offset of a clothoid is not a clothoid, so the pair is kept; stations are those of the guide. With its
/// curvature k and offset d, everything follows from 1 - k d: metres driven per metre of the guide.
struct OffsetCurve {
  Curve guide;
  double offset_m = 0;

  friend bool operator==(const OffsetCurve&, const OffsetCurve&) = default;
};

struct OffsetPath {
  Path guide;
  double offset_m = 0;

  friend bool operator==(const OffsetPath&, const OffsetPath&) = default;
};

/// Least of 1 - k d over the curve, at one of its ends as k is linear. The offset has a cusp, or runs
/// backwards somewhere, exactly where this is not above 0.
double least_stretching(const OffsetCurve& offset);
bool has_cusp(const OffsetCurve& offset);
bool has_cusp(const OffsetPath& offset);

/// What stands beside station `s_m` of the guide. Its heading is the guide's.
struct OffsetState {
  Point at;
  double heading_rad = 0;
  double curvature_per_m = 0;   ///< k / (1 - k d)
  double sharpness_per_m2 = 0;  ///< k' / (1 - k d)^3, per metre of the offset
  double stretching = 0;        ///< 1 - k d: the offset's speed over the guide's
};
/// None where the offset has a cusp at this station or runs backwards there.
std::optional<OffsetState> state_at(const OffsetCurve& offset, double s_m);

/// Metres of the offset from the guide's start to its station `s_m`: s - d (k s + k' s^2 / 2), exactly. @pre
/// no cusp up to there.
double length_to_m(const OffsetCurve& offset, double s_m);
double length_m(const OffsetCurve& offset);
double length_m(const OffsetPath& offset);
/// The guide's station at which the offset has run `length_m`; the inverse of length_to_m. None where the
/// offset comes to a cusp before.
std::optional<double> station_m(const OffsetCurve& offset, double length_m);

/// Largest curvature and sharpness by size anywhere on the offset, from closed forms: both are greatest at an
/// end. None where it has a cusp.
std::optional<CurveLimits> largest_bend(const OffsetCurve& offset);
std::optional<CurveLimits> largest_bend(const OffsetPath& offset);

/// Has the offset no cusp, and are its curvature and sharpness within the limits, to one part in 1e9?
bool keeps(const OffsetCurve& offset, const CurveLimits& limits);
bool keeps(const OffsetPath& offset, const CurveLimits& limits);

}  // namespace selion
