// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/motion/path.hpp"
#include "selion/motion/swings.hpp"

namespace selion {

/// What the machine's steering allows at `speed_mps` (Cariou et al. 2020, eq. 16 and 20).
CurveLimits limits_at(const Machine& machine, double speed_mps);

/// A turn by `deflection_rad` (left positive, |deflection| < 2 pi) that starts and ends straight: clothoid,
/// arc, clothoid, or a clothoid pair of the limit's sharpness where the curvature limit is not reached.
/// Starts at `from`.
Path swing(const Pose& from, double deflection_rad, const Swings& swings);
/// The same for a single one.
Path swing(const Pose& from, double deflection_rad, const CurveLimits& limits);

/// Of a swing by |deflection| < pi: from its start to the corner of its two tangents, and from that corner to
/// the curve.
struct Corner {
  double tangent_m = 0;
  double cut_m = 0;
};
Corner corner_of(double deflection_rad, const CurveLimits& limits);

/// Every candidate starts and ends straight (curvature 0) within 1e-12 m and 1e-12 rad of the poses given (a
/// straight within 1e-9, so that rounded poses in line need no swings), is curvature-continuous but for
/// changes of gear and pivots, and keeps the limits. Empty where the family has none.
using TurnFamily = std::vector<Path> (*)(const Pose& from, const Pose& to, const Swings& swings);

/// What a turn asks of a machine besides steering.
enum class Needs { nothing, reverse, pivot };

struct TurnKind {
  std::string_view name;
  std::string_view about;
  Needs needs = Needs::nothing;
  TurnFamily candidates = nullptr;
};

/// What the machine may do besides steering.
struct Manoeuvres {
  bool reverse = false;
  bool pivot = false;  ///< rotate on the spot

  friend bool operator==(const Manoeuvres&, const Manoeuvres&) = default;
};

/// Only a differential machine pivots.
Manoeuvres manoeuvres_of(const Machine& machine);
bool allows(const Manoeuvres& may, Needs needs);

/// loop and flat (between antiparallel swaths, the shorter one driven on), dip, straight and the Dubins words
/// with clothoids, fishtail and pivot (any two poses).
std::span<const TurnKind> turns();

/// The candidates of all families, shortest first (flat U-turns to 0.7 mm), each way once; never empty. Poses
/// that agree are connected by a straight of length 0. A family is worked out only when it might have the
/// next one: who needs one way pays for one.
class Connections {
 public:
  /// Forwards only. `swings` must outlive this.
  Connections(const Pose& from, const Pose& to, const Swings& swings);
  Connections(const Pose& from, const Pose& to, const Swings& swings, const Manoeuvres& may);
  ~Connections();
  Connections(Connections&&) noexcept;
  Connections& operator=(Connections&&) noexcept;
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;

  /// The next longer one, of at most `longest_m`; absent when there are no more.
  std::optional<Path> next(double longest_m = std::numeric_limits<double>::infinity());

 private:
  class Queue;
  std::unique_ptr<Queue> queue_;
};

/// All of them at once.
std::vector<Path> connections(const Pose& from, const Pose& to, const CurveLimits& limits);

}  // namespace selion
