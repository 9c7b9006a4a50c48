// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "selion/core/point.hpp"

namespace selion::verifying {

/// With its sides along the axes; new: around nothing.
struct Box {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void take_in(Point p) {
    low = {std::min(low.x_m, p.x_m), std::min(low.y_m, p.y_m)};
    high = {std::max(high.x_m, p.x_m), std::max(high.y_m, p.y_m)};
  }
};

constexpr double kOff_m = 1e-6;  // far more than the roundings of doubles here

inline bool apart(const Box& a, const Box& b) {
  return a.low.x_m > b.high.x_m + kOff_m || b.low.x_m > a.high.x_m + kOff_m ||
         a.low.y_m > b.high.y_m + kOff_m || b.low.y_m > a.high.y_m + kOff_m;
}

}  // namespace selion::verifying
