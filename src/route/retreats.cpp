// SPDX-License-Identifier: GPL-3.0-or-later
#include "retreats.hpp"

#include <algorithm>
#include <cmath>

namespace selion {
namespace {

constexpr double kFarthestRetreat_m = 150;
constexpr double kRetreatStep_m = 6;
constexpr std::size_t kMostRetreats = 14;
constexpr double kStraight_per_m = 1e-9;

struct Backing {
  Path run;
  double length_m = 0;
  std::vector<Path> found;

  [[nodiscard]] bool done() const { return length_m > kFarthestRetreat_m || found.size() >= kMostRetreats; }
};

/// Backs over one stretch more; where the wheels stand straight on it, a retreat may end.
void back_over(Backing& backing, const Stretch& stretch) {
  const double whole_m = stretch.curve.length_m;
  const bool straight = is_straight(stretch.curve);
  const bool may_end = straight || std::abs(stretch.curve.curvature_per_m) < kStraight_per_m;
  const int steps = straight ? std::max(1, static_cast<int>(std::ceil(whole_m / kRetreatStep_m))) : 1;
  append(backing.run, backed({stretch}));
  for (int k = 1; may_end && k <= steps && backing.found.size() < kMostRetreats; ++k) {
    backing.found.push_back(backing.run);
    backing.found.back().back().curve.length_m = whole_m * k / steps;
  }
  backing.length_m += whole_m;
}

}  // namespace

std::vector<Path> retreats(const std::vector<RoutePiece>& driven) {
  Backing backing;
  for (std::size_t i = driven.size(); i > 0; --i) {
    const Path& path = driven[i - 1].path;
    for (std::size_t k = path.size(); k > 0; --k) {
      if (backing.done()) return std::move(backing.found);
      back_over(backing, path[k - 1]);
    }
  }
  return std::move(backing.found);
}

}  // namespace selion
