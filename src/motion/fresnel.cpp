// SPDX-License-Identifier: GPL-3.0-or-later
#include "fresnel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "direction.hpp"
#include "fresnel_table.hpp"

namespace selion {
namespace {

constexpr double kPi = std::numbers::pi;
// Below this the power series is used.
constexpr double kNear = 0.75;

/// In four strands, which a processor computes side by side.
double polynomial(const std::array<double, 12>& c, double x) {
  const double xx = x * x;
  const double y = xx * xx;
  const double even = (c[0] + y * (c[4] + y * c[8])) + xx * (c[2] + y * (c[6] + y * c[10]));
  const double odd = (c[1] + y * (c[5] + y * c[9])) + xx * (c[3] + y * (c[7] + y * c[11]));
  return even + x * odd;
}

double series(const std::array<double, 10>& c, double x) {
  double sum = 0;
  for (std::size_t n = c.size(); n-- > 0;) sum = sum * x + c[n];
  return sum;
}

}  // namespace

Auxiliary auxiliary(double t) {
  constexpr double kPerUnit = kFresnelPieces / kFresnelFar;
  const double at = t * kPerUnit;
  const auto piece = std::min(static_cast<std::size_t>(at), kFresnelPieces - 1);
  const double x = 2 * (at - static_cast<double>(piece)) - 1;
  return {polynomial(kFresnelF[piece], x), polynomial(kFresnelG[piece], x)};
}

Auxiliary far_auxiliary(double inverse) {
  constexpr double kSpan = kPi * kFresnelFar * kFresnelFar;
  const double ratio = kSpan * inverse;
  const double x = 2 * ratio * ratio - 1;
  return {polynomial(kFresnelFarF, x), polynomial(kFresnelFarG, x)};
}

FresnelPair fresnel(double t) {
  const double size = std::abs(t);
  const double square = t * t;
  if (size < kNear) {
    const double fourth = square * square;
    return {t * series(kFresnelNearC, fourth), t * square * series(kFresnelNearS, fourth)};
  }
  const double side = t < 0 ? -1 : 1;
  if (size > 0x1p+53) return {side * 0.5, side * 0.5};
  const Point turn = quarter_direction(exact_product(t, t));
  Auxiliary part;
  if (size < kFresnelFar) {
    part = auxiliary(size);
  } else {
    const double inverse = 1 / (kPi * square);
    part = far_auxiliary(inverse);
    part = {part.f / (kPi * size), part.g * inverse / (kPi * size)};
  }
  return {side * (0.5 + (part.f * turn.y_m - part.g * turn.x_m)),
          side * (0.5 - (part.f * turn.x_m + part.g * turn.y_m))};
}

}  // namespace selion
