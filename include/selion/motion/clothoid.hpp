// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "selion/core/point.hpp"
#include "selion/motion/path.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// The one clothoid from pose to pose that turns by `wrapped(to - chord) - wrapped(from - chord)` in all, the
/// least for poses that roughly face along their chord. Its end agrees to 1e-12 of the distance, where it is
/// no longer than 1000 distances: it grows without bound as both poses turn away from each other. It may bend
/// as tightly as it must (Bertolazzi and Frego 2015, G1 Hermite interpolation).
/// @pre the points differ; where they coincide there is no chord, and the answer is a curve of length 0.
Curve clothoid_between(const Pose& from, const Pose& to);

/// A pose and how the way bends there, left positive.
struct BentPose {
  Pose pose;
  double curvature_per_m = 0;

  friend bool operator==(const BentPose&, const BentPose&) = default;
};

/// Three clothoids end to end, of continuous curvature, that lead from the one pose and curvature to the
/// other; they turn as `clothoid_between` does in all. None where the points coincide or the search fails
/// (after Bertolazzi and Frego 2018, G2 Hermite interpolation, with a search of our own: see
/// docs/methods.md). They keep no limit: ask `keeps`.
std::optional<std::array<Curve, 3>> clothoids_between(const BentPose& from, const BentPose& to);

/// Largest curvature and sharpness by size anywhere on the path; 0 where it is empty.
CurveLimits largest_bend(const Path& path);

/// Are curvature and sharpness within the limits, to one part in 1e9, everywhere on the path?
bool keeps(const Path& path, const CurveLimits& limits);

}  // namespace selion
