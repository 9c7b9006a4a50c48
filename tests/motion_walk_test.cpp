// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <random>

#include "motion/walk.hpp"
#include "selion/motion/path.hpp"

using namespace selion;

namespace {

/// How far a point of the body strays from the chord of its way along the curve.
double farthest_off_chord_m(const Curve& curve, Point on_body) {
  const auto at = [&](double share) {
    const CurveState state = state_at(curve, share * curve.length_m);
    return placed(Pose{state.at, state.heading_rad}, on_body);
  };
  const Point from = at(0);
  const Point chord = at(1) - from;
  double most_m = 0;
  for (double share = 0.05; share < 1; share += 0.05) {
    const double along = std::clamp(dot(at(share) - from, chord) / dot(chord, chord), 0.0, 1.0);
    most_m = std::max(most_m, distance_m(at(share), from + along * chord));
  }
  return most_m;
}

}  // namespace

TEST_CASE("no point of the body strays further from a chord than is said, on sharp clothoids too",
          "[motion]") {
  constexpr double kStray_m = 0.002;
  std::mt19937 random{11};
  std::uniform_real_distribution<double> share{-1, 1};
  double most_m = 0;
  for (int i = 0; i < 2000; ++i) {
    Curve curve{{}, 0, 0.6 * share(random), 3 * share(random), 0.5};
    const double reach_m = 2.2 + 1.8 * share(random);
    curve.length_m = std::min(curve.length_m, chord_m(curve, reach_m, kStray_m));
    most_m = std::max(most_m, farthest_off_chord_m(curve, reach_m * unit(4 * share(random))));
  }
  CHECK(most_m <= kStray_m * (1 + 1e-9));
  CHECK(most_m >= 0.5 * kStray_m);
}
