// SPDX-License-Identifier: GPL-3.0-or-later
#include "displacement.hpp"

#include <cmath>
#include <numbers>

#include "direction.hpp"
#include "fresnel.hpp"
#include "fresnel_table.hpp"

// While the heading turns little, a power series about the middle of the way; else the antiderivative of
// exp(i heading), (g + i f) exp(i heading) by the auxiliary functions of Fresnel's integrals, at both ends.
// That form has no cliff: towards an arc it becomes the arc's own. Where the curvature changes its sign, the
// two ends are on two branches, and the whole spiral is added, in the direction of the heading there.
namespace selion {
namespace {

constexpr double kPi = std::numbers::pi;

// Largest change of heading over half the way, counted at the larger curvature, for the series: of few terms,
// of more. Above kLittle the antiderivatives' rounding errors are at most 1 / (2 kLittle) times those of the
// way.
constexpr double kLeast = 0.125;
constexpr double kLittle = 0.7;
// What a term of the series may add at most to be left out.
constexpr double kNothing = 1e-17;

/// The series' term p^2m q^n, where its factor is 1 / ((2m)! n! (2m + 2n + 1)).
constexpr double factor(int m, int n) {
  double below = 2 * m + 2 * n + 1;
  for (int i = 2; i <= 2 * m; ++i) below *= i;
  for (int i = 2; i <= n; ++i) below *= i;
  return ((m + n / 2) % 2 == 0 ? 1 : -1) / below;
}

/// The term's largest value where |p| + 2 |q| <= `phase`.
constexpr double largest_term(double phase, int m, int n) {
  double term = factor(m, n);
  if (term < 0) term = -term;
  for (int i = 0; i < 2 * m; ++i) term *= phase * 2 * m / (2 * m + n);
  for (int i = 0; i < n; ++i) term *= phase / 2 * n / (2 * m + n);
  return term;
}

constexpr bool is_needed(bool little, int m, int n) {
  return largest_term(little ? kLittle : kLeast, m, n) > kNothing;
}

/// What multiplies q^n, but for powers of i: a polynomial in p^2.
template <bool Little, int N, int M>
double moment(double pp) {
  if constexpr (is_needed(Little, M, N)) return factor(M, N) + pp * moment<Little, N, M + 1>(pp);
  return 0;
}

/// Sum over the moments N, N + 2, ... times (q^2)^0, (q^2)^1, ...
template <bool Little, int N>
double every_other(double pp, double qq) {
  if constexpr (is_needed(Little, 0, N))
    return moment<Little, N, 0>(pp) + qq * every_other<Little, N + 2>(pp, qq);
  return 0;
}

/// Mean of exp(i (p x + q x^2)) over [-1, 1]; the odd part drops out.
template <bool Little>
Point mean_direction(double p, double q) {
  const double pp = p * p;
  const double qq = q * q;
  return {every_other<Little, 0>(pp, qq), q * every_other<Little, 1>(pp, qq)};
}

Point times(Point a, Point b) { return {a.x_m * b.x_m - a.y_m * b.y_m, a.x_m * b.y_m + a.y_m * b.x_m}; }

double sign_of(double k, double otherwise) {
  if (k == 0) k = otherwise;
  return k < 0 ? -1 : 1;
}

/// g + i f in metres where the curvature is k; `scale` is sqrt(pi / c), used where k is small against it.
/// @pre c >= 0, and k is not 0 where c is.
Point antiderivative(double k, double c, double sign, double scale) {
  constexpr double kFar = kPi * kFresnelFar * kFresnelFar;
  if (k * k >= kFar * c) {
    const double radius = 1 / k;
    const double ratio = c * radius * radius;
    const Auxiliary part = far_auxiliary(ratio);
    return {part.g * ratio * radius, part.f * radius};
  }
  const Auxiliary part = auxiliary(std::abs(k) * scale * (1 / kPi));
  return {sign * scale * part.g, sign * scale * part.f};
}

/// The whole spiral, from the one eye to the other: it leads half a quarter left of the heading where the
/// curvature is 0, which lies k^2 / (2c) before the start's.
Point spiral(double heading, double k, double c, double scale) {
  const Wide square = exact_product(k, k);
  const double before = square.high / (2 * c);
  const Wide back = exact_product(before, 2 * c);
  const double rest = ((square.high - back.high) - back.low + square.low) / (2 * c);
  const Point along = direction(sum(heading, {-before, -rest}));
  return scale * (along + left_of(along));
}

Wide heading_change(double k, double c, double s) {
  const Wide growth = exact_product(c, s / 2);
  const Wide mean = sum(k, growth);
  const Wide change = exact_product(mean.high, s);
  return {change.high, change.low + mean.low * s};
}

Point mirrored(Point p) { return {p.x_m, -p.y_m}; }

/// @pre c >= 0.
Point far(const Curve& curve, double s, const EndDirections& ends) {
  const double k = curve.curvature_per_m;
  const double c = curve.sharpness_per_m2;
  const double end = k + c * s;
  const double sign = sign_of(k, end);
  const double end_sign = sign_of(end, k);
  const double scale = std::sqrt(kPi / c);
  const Point way = times(antiderivative(k, c, sign, scale), ends.first) -
                    times(antiderivative(end, c, end_sign, scale), ends.last);
  return sign == end_sign ? way : way + (end_sign - sign) / 2 * spiral(curve.heading_rad, k, c, scale);
}

EndDirections end_directions(const Curve& curve, double s) {
  const Wide change = heading_change(curve.curvature_per_m, curve.sharpness_per_m2, s);
  return {direction({curve.heading_rad, 0}), direction(sum(curve.heading_rad, change))};
}

/// `ends` gives the directions at both ends when they are asked for.
template <class Ends>
Point displaced(const Curve& curve, double s, Ends ends) {
  const double k = curve.curvature_per_m;
  const double c = curve.sharpness_per_m2;
  const double half = s / 2;
  const double p = (k + c * half) * half;
  const double q = c * half * half / 2;
  const double phase = std::abs(p) + 2 * std::abs(q);
  if (phase == 0) return s * direction({curve.heading_rad, 0});
  if (phase <= kLittle) {
    const Point mean = phase <= kLeast ? mean_direction<false>(p, q) : mean_direction<true>(p, q);
    return s * times(mean, direction(exact_sum(curve.heading_rad, (k + c * half / 2) * half)));
  }
  const EndDirections known = ends();
  if (c >= 0) return far(curve, s, known);
  const Curve other{{}, -curve.heading_rad, -k, -c, 0};
  return mirrored(far(other, s, {mirrored(known.first), mirrored(known.last)}));
}

}  // namespace

double turned_rad(const Curve& curve, double s_m) {
  return (curve.curvature_per_m + curve.sharpness_per_m2 * s_m / 2) * s_m;
}

Point displacement(const Curve& curve, double s_m) {
  return displaced(curve, s_m, [&] { return end_directions(curve, s_m); });
}

Point displacement(const Curve& curve, double s_m, const EndDirections& ends) {
  return displaced(curve, s_m, [&] { return ends; });
}

}  // namespace selion
