// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "selion/geometry/boolean.hpp"

int main() {
  const selion::Polygon field{{{0, 0}, {100, 0}, {100, 50}, {0, 50}}, {}};
  const double left_m2 = selion::area_m2(selion::inset({field}, 5));
  std::cout << "100 m x 50 m, less 5 m on every side: " << left_m2 << " m2\n";
  return left_m2 == 90 * 40 ? 0 : 1;
}
