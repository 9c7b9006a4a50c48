// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/motion/path.hpp"

namespace selion {

struct CurveLimits {
  double curvature_per_m = 0;
  double sharpness_per_m2 = 0;

  friend bool operator==(const CurveLimits&, const CurveLimits&) = default;
};

/// What the machine's steering allows at `speed_mps` (Cariou et al. 2020, eq. 16 and 20).
CurveLimits limits_at(const Machine& machine, double speed_mps);

/// A turn by `deflection_rad` (left positive, |deflection| < 2 pi) that starts and ends straight: clothoid,
/// arc, clothoid, or a clothoid pair of the limit's sharpness where the curvature limit is not reached.
/// Starts at `from`.
Path swing(const Pose& from, double deflection_rad, const CurveLimits& limits);

/// Of a swing by |deflection| < pi: from its start to the corner of its two tangents, and from that corner to
/// the curve.
struct Corner {
  double tangent_m = 0;
  double cut_m = 0;
};
Corner corner_of(double deflection_rad, const CurveLimits& limits);

/// Every candidate is curvature-continuous, starts and ends straight (curvature 0) within 1e-9 m and 1e-9 rad
/// of the poses given, and keeps the limits. Empty where the family has none.
using TurnFamily = std::vector<Path> (*)(const Pose& from, const Pose& to, const CurveLimits& limits);

struct TurnKind {
  std::string_view name;
  std::string_view about;
  TurnFamily candidates;
};

/// loop and flat (between antiparallel swaths, the shorter one driven on), dip, straight and the Dubins words
/// with clothoids (any two poses).
std::span<const TurnKind> turns();

/// The candidates of all families, shortest first, each way once; never empty. Poses that agree are connected
/// by a straight of length 0.
std::vector<Path> connections(const Pose& from, const Pose& to, const CurveLimits& limits);

}  // namespace selion
