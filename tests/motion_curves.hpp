// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "selion/motion/path.hpp"

namespace selion {

/// Lines, arcs, clothoids with and without a turning point, some of many turns, about the origin.
inline std::vector<Curve> any_curves(std::size_t count) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> any{-1, 1};
  std::vector<Curve> curves;
  while (curves.size() < count) {
    const double length = 30 * std::abs(any(random));
    const double curvature = curves.size() % 7 == 0 ? 0 : any(random) * std::pow(10, 1.5 * any(random) - 0.5);
    const double sharpness =
        curves.size() % 5 == 0 ? 0 : any(random) * std::pow(10, 1.5 * any(random) - 1) / length;
    curves.push_back({{3 * any(random), 3 * any(random)}, 3 * any(random), curvature, sharpness, length});
  }
  return curves;
}

}  // namespace selion
