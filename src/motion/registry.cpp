// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "families.hpp"
#include "offer.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr auto kTurns = std::to_array<TurnKind>({
    {"straight", "ahead, where the goal lies there", straight_turn},
    {"loop", "an omega to a swath nearer than two turning radii", loop_turn},
    {"dip", "one turn that straightens a little in its middle", dip_turn},
    {"flat", "quarter turn, straight, quarter turn, to a swath further off", flat_turn},
    {"lsl", "left, straight, left", lsl_turn},
    {"rsr", "right, straight, right", rsr_turn},
    {"lsr", "left, straight, right", lsr_turn},
    {"rsl", "right, straight, left", rsl_turn},
    {"lrl", "left, right, left", lrl_turn},
    {"rlr", "right, left, right", rlr_turn},
});

struct Measured {
  double length_m = 0;
  Path path;
};

/// Families overlap: a flat turn is also left, straight, left. The one of fewer stretches stands first and
/// stays.
bool same_way(const Measured& a, const Measured& b) {
  if (std::abs(a.length_m - b.length_m) > 1e-7) return false;
  const auto quarter = [](const Measured& m) {
    double left = m.length_m / 4;
    std::size_t i = 0;
    for (; i + 1 < m.path.size() && left > m.path[i].curve.length_m; ++i) left -= m.path[i].curve.length_m;
    return vehicle_pose(m.path[i], left).at;
  };
  return distance_m(quarter(a), quarter(b)) < 1e-6;
}

std::vector<Measured> candidates(const Pose& from, const Pose& to, const CurveLimits& limits) {
  std::vector<Measured> found;
  for (const TurnKind& kind : kTurns) {
    for (Path& path : kind.candidates(from, to, limits)) found.push_back({length_m(path), std::move(path)});
  }
  return found;
}

/// Where nothing else fits: straight on until the goal lies so far back that a turn towards it does.
std::vector<Measured> driven_on(const Pose& from, const Pose& to, const CurveLimits& limits) {
  const double k = limits.curvature_per_m;
  double on = 1 / k + k / limits.sharpness_per_m2;
  std::vector<Measured> found;
  for (int i = 0; i < 30 && found.empty(); ++i, on *= 2) {
    Drawn start{{}, from};
    draw_line(start, on);
    for (Measured& rest : candidates(start.at, to, limits)) {
      Path path = start.path;
      append(path, rest.path);
      found.push_back({on + rest.length_m, std::move(path)});
    }
  }
  return found;
}

}  // namespace

std::span<const TurnKind> turns() { return kTurns; }

std::vector<Path> connections(const Pose& from, const Pose& to, const CurveLimits& limits) {
  std::vector<Measured> found = candidates(from, to, limits);
  if (found.empty()) found = driven_on(from, to, limits);
  std::stable_sort(found.begin(), found.end(),
                   [](const Measured& a, const Measured& b) { return a.length_m < b.length_m; });
  found.erase(std::unique(found.begin(), found.end(), same_way), found.end());
  std::vector<Path> paths;
  paths.reserve(found.size());
  for (Measured& one : found) paths.push_back(std::move(one.path));
  return paths;
}

}  // namespace selion
