// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace selion {

/// A place of a function: argument and value.
struct RootEnd {
  double x = 0;
  double y = 0;
};

/// The root between `a` and `b`, where y changes its sign, to the last bits of x (Chandrupatla 1997: inverse
/// quadratic steps where the function allows, else bisection).
/// @pre a.y and b.y differ in sign, or one of them is 0.
template <class Function>
double root_between(RootEnd a, RootEnd b, Function y_of) {
  if (a.y == 0) return a.x;
  RootEnd third = b;  // the last end to be replaced
  double share = 0.5;
  for (int i = 0; i < 100 && b.y != 0; ++i) {
    const double x = b.x + share * (a.x - b.x);
    const RootEnd now{x, y_of(x)};
    third = b;
    if ((now.y > 0) != (b.y > 0)) {
      third = a;
      a = b;
    }
    b = now;
    const double least =
        (2 * std::numeric_limits<double>::epsilon() * std::abs(b.x) + 1e-18) / std::abs(a.x - b.x);
    if (!(least < 0.5)) break;
    const double xi = (b.x - a.x) / (third.x - a.x);
    const double phi = (b.y - a.y) / (third.y - a.y);
    const bool smooth = phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi;
    share = smooth ? b.y / (a.y - b.y) * (third.y / (a.y - third.y)) +
                         (third.x - b.x) / (a.x - b.x) * (b.y / (third.y - b.y)) * (a.y / (third.y - a.y))
                   : 0.5;
    share = std::clamp(share, least, 1 - least);
  }
  return std::abs(a.y) < std::abs(b.y) ? a.x : b.x;
}

}  // namespace selion
