// SPDX-License-Identifier: GPL-3.0-or-later
#include "crossing.hpp"

#include <algorithm>
#include <cmath>

namespace selion {
namespace {

/// Sign of the turn a -> b -> c: in doubles where the rounding error cannot change it (Shewchuk 1997, filter
/// A), else in long doubles, whose 64-bit products of field-sized differences are exact far below a
/// micrometre.
int turn_sign(Point a, Point b, Point c) {
  const double left = (b.x_m - a.x_m) * (c.y_m - a.y_m);
  const double right = (b.y_m - a.y_m) * (c.x_m - a.x_m);
  const double det = left - right;
  if (std::abs(det) > 4e-16 * (std::abs(left) + std::abs(right))) return det > 0 ? 1 : -1;
  using Wide = long double;
  const Wide wide =
      (Wide{b.x_m} - a.x_m) * (Wide{c.y_m} - a.y_m) - (Wide{b.y_m} - a.y_m) * (Wide{c.x_m} - a.x_m);
  return wide > 0 ? 1 : wide < 0 ? -1 : 0;
}

}  // namespace

RayMeets ray_meets(Point a, Point b, Point p) {
  if (p.y_m < std::min(a.y_m, b.y_m) || p.y_m > std::max(a.y_m, b.y_m)) return RayMeets::nothing;
  const int sign = turn_sign(a, b, p);
  if (sign == 0 && std::min(a.x_m, b.x_m) <= p.x_m && p.x_m <= std::max(a.x_m, b.x_m))
    return RayMeets::the_edge_at_p;
  const bool across = (a.y_m > p.y_m) != (b.y_m > p.y_m);
  return across && (sign > 0) == (b.y_m > a.y_m) ? RayMeets::crossing : RayMeets::nothing;
}

}  // namespace selion
