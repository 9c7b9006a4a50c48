// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "selion/core/angle.hpp"

using namespace selion;

TEST_CASE("an angle is wrapped without rounding, into (-pi, pi]", "[core][angle]") {
  constexpr double kPi = std::numbers::pi;
  CHECK(wrapped(kPi) == kPi);
  CHECK(wrapped(-kPi) == kPi);
  CHECK(wrapped(2 * kPi) == 0);
  CHECK(wrapped(-2 * kPi) == 0);
  CHECK(std::isnan(wrapped(std::numeric_limits<double>::quiet_NaN())));
  std::mt19937 random{1};
  std::uniform_real_distribution<double> any{-20, 20};
  for (int i = 0; i < 10000; ++i) {
    const double angle = any(random);
    CHECK(wrapped(angle) == std::remainder(angle, 2 * kPi));
    CHECK(std::abs(wrapped(angle)) <= kPi);
  }
}
