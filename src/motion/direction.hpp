// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/core/point.hpp"

namespace selion {

/// high + low, not added up: twice the digits of a double.
struct Wide {
  double high = 0;
  double low = 0;
};

/// Without rounding (Knuth 1969, 4.2.2, theorem B).
inline Wide exact_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// Without rounding (Dekker 1971, by Veltkamp's split). Not std::fma: where the processor lacks it, that is
/// emulated at ten times the cost. @pre |a|, |b| < 1e300.
inline Wide exact_product(double a, double b) {
  constexpr double kSplit = 134217729;  // 2^27 + 1
  const double a_high = kSplit * a - (kSplit * a - a);
  const double b_high = kSplit * b - (kSplit * b - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  const double product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline Wide sum(double a, Wide b) {
  const Wide high = exact_sum(a, b.high);
  return {high.high, high.low + b.low};
}

/// (cos, sin), to 1e-16 of 1. Sums and products only, so that every machine and every C library gives the
/// same bytes. @pre |low| is at most an ulp of high, or so.
Point direction(Wide angle_rad);

/// The direction of `quarters` quarter turns: no pi is taken off, so large numbers lose nothing.
Point quarter_direction(Wide quarters);

}  // namespace selion
