// SPDX-License-Identifier: GPL-3.0-or-later
#include "direction.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace selion {
namespace {

// pi/2 in three parts. The first two have 30 bits, so that their products with up to 2^23 are exact.
constexpr double kQuarterHigh = 0x1.921fb54p+0;
constexpr double kQuarterMiddle = 0x1.10b46118p-30;
constexpr double kQuarterLow = 0x1.313198a2e037p-61;
constexpr double kMostQuarters = 1 << 22;

/// The factors of x^2n in sin(x) / x (First = 1) and cos(x) (First = 0), Taylor's.
template <int First>
constexpr auto kTaylor = [] {
  std::array<double, 9> factors{1};
  for (int n = 1; n < 9; ++n) {
    const double last = 2 * n + First;
    factors[static_cast<std::size_t>(n)] = -factors[static_cast<std::size_t>(n) - 1] / (last * (last - 1));
  }
  return factors;
}();

double nearest_integer(double x) {
  constexpr double kRound = 0x1.8p+52;
  return (x + kRound) - kRound;
}

/// (cos, sin) of high + low. @pre |high| is at most pi/4.
Point small_direction(double high, double low) {
  const auto& s = kTaylor<1>;
  const auto& c = kTaylor<0>;
  const double z = high * high;
  const double zz = z * z;
  const double sin_tail =
      (s[1] + zz * (s[3] + zz * (s[5] + zz * s[7]))) + z * (s[2] + zz * (s[4] + zz * (s[6] + zz * s[8])));
  const double cos_tail =
      (c[2] + zz * (c[4] + zz * (c[6] + zz * c[8]))) + z * (c[3] + zz * (c[5] + zz * c[7]));
  const double half = z / 2;
  const double bulk = 1 - half;
  return {bulk + (((1 - bulk) - half) + (zz * cos_tail - high * low)),
          high + (z * high * sin_tail + low * bulk)};
}

/// Without a branch: which quarter comes next is not foreseen.
Point turned(Point p, std::int64_t quarters) {
  const bool is_odd = (quarters & 1) != 0;
  const auto sign = static_cast<double>(1 - (quarters & 2));
  return {sign * (is_odd ? -p.y_m : p.x_m), sign * (is_odd ? p.x_m : p.y_m)};
}

}  // namespace

Point direction(Wide angle_rad) {
  const double quarters = nearest_integer(angle_rad.high * (2 / std::numbers::pi));
  if (!(std::abs(quarters) <= kMostQuarters)) {
    const Point bulk = unit(angle_rad.high);
    return bulk + angle_rad.low * left_of(bulk);
  }
  const double bulk = angle_rad.high - quarters * kQuarterHigh;
  const double middle = quarters * kQuarterMiddle;
  // Where `middle` is the larger one, their difference has no rounding error, so the short form is exact.
  const double rest = bulk - middle;
  const double lost = (bulk - rest) - middle;
  const double low = (lost - quarters * kQuarterLow) + angle_rad.low;
  const double high = rest + low;
  return turned(small_direction(high, (rest - high) + low), static_cast<std::int64_t>(quarters));
}

Point quarter_direction(Wide quarters) {
  // Past 2^50 the low part has whole turns too.
  if (std::abs(quarters.high) > 0x1p+50)
    quarters = exact_sum(std::fmod(quarters.high, 4), std::fmod(quarters.low, 4));
  const double whole = nearest_integer(quarters.high);
  const double part = (quarters.high - whole) + quarters.low;
  return turned(small_direction(part * (std::numbers::pi / 2), 0), static_cast<std::int64_t>(whole));
}

}  // namespace selion
