// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "selion/motion/path.hpp"

namespace selion {

struct Stations {
  double from_m = 0;
  double to_m = 0;
};

/// How a stretch of one curve lies beside another curve.
struct Beside {
  double least_m = 0;  ///< no place of it is nearer,
  double most_m = 0;   ///< and none farther
  Stations feet;       ///< where on the other curve its ends belong
};

/// None where that cannot be told to 1e-10 m, or half the distance: the stretch is too long for how it bends,
/// or reaches past the other curve's ends. @pre `near` is a stretch of `other` about as long as `stretch`,
/// near it and parallel.
std::optional<Beside> beside(const Curve& curve, Stations stretch, const Curve& other, Stations near);

}  // namespace selion
