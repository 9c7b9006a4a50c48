// SPDX-License-Identifier: GPL-3.0-or-later
#include "fresnel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

// A clothoid is evaluated by what its heading does: while the heading turns little, Gauss-Legendre; where the
// curvature stays away from 0, the asymptotic series at both ends; else as a difference of Fresnel integrals,
// which are made of the same two.
namespace selion {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

struct Node {
  double x;
  double weight;
};
// The positive half of the Gauss-Legendre rules of 10 and 16 points.
constexpr auto kCoarse = std::to_array<Node>({{0.14887433898163121088, 0.29552422471475287017},
                                              {0.4333953941292471908, 0.26926671930999635509},
                                              {0.67940956829902440623, 0.219086362515982044},
                                              {0.86506336668898451073, 0.14945134915058059315},
                                              {0.97390652851717172008, 0.066671344308688137594}});
constexpr auto kFine = std::to_array<Node>({{0.095012509837637440185, 0.18945061045506849629},
                                            {0.28160355077925891323, 0.18260341504492358887},
                                            {0.45801677765722738634, 0.16915651939500253819},
                                            {0.61787624440264374845, 0.14959598881657673208},
                                            {0.7554044083550030339, 0.12462897125553387205},
                                            {0.86563120238783174388, 0.09515851168249278481},
                                            {0.94457502307323257608, 0.062253523938647892863},
                                            {0.9894009349916499326, 0.027152459411754094852}});
// Largest change of heading over half the length, counted at the larger curvature, at which each rule errs by
// 1e-16.
constexpr double kCoarsePhase = 0.7;
constexpr double kFinePhase = 3;
// Least curvature^2 / |sharpness| at which the asymptotic series reaches 1e-16 (its smallest term is
// exp(-half of this)).
constexpr double kAsymptotic = 75;

Complex turned(Complex z, double angle_rad) { return z * Complex{std::cos(angle_rad), std::sin(angle_rad)}; }

/// Mean of exp(i (p x + q x^2)) over [-1, 1]; the odd part drops out.
template <std::size_t Size>
Complex mean_direction(double p, double q, const std::array<Node, Size>& rule) {
  double along = 0;
  double across = 0;
  for (const Node node : rule) {
    const double even = node.weight * std::cos(p * node.x);
    const double phase = q * node.x * node.x;
    along += even * std::cos(phase);
    across += even * std::sin(phase);
  }
  return {along, across};
}

double half_phase(double k, double c, double s) {
  return std::max(std::abs(k), std::abs(k + c * s)) * std::abs(s) / 2;
}

/// Displacement from heading 0. @pre the phase is at most kFinePhase.
Complex by_quadrature(double k, double c, double s) {
  const double half = s / 2;
  const double middle_heading = (k + c * half / 2) * half;
  const double p = (k + c * half) * half;
  const double q = c * half * half / 2;
  const Complex mean =
      half_phase(k, c, s) <= kCoarsePhase ? mean_direction(p, q, kCoarse) : mean_direction(p, q, kFine);
  return turned(s * mean, middle_heading);
}

/// The A in exp(i heading) A, an antiderivative of exp(i heading), where the curvature is k: repeated
/// integration by parts.
Complex asymptotic_end(double k, double c) {
  const Complex ratio{0, -c / (k * k)};
  Complex term{0, -1 / k};
  Complex sum = term;
  for (int n = 1; n < 40 && std::abs(term.real()) + std::abs(term.imag()) > 1e-18 * std::abs(1 / k); ++n) {
    term *= (2 * n - 1.0) * ratio;
    sum += term;
  }
  return sum;
}

bool is_asymptotic(double k, double c) { return k * k >= kAsymptotic * std::abs(c); }

/// pi/2 t^2 modulo 2 pi: the square's rounding error, which grows with t, is put back.
double fresnel_phase(double t) {
  const double square = t * t;
  return kPi / 2 * (std::fmod(square, 4.0) + std::fma(t, t, -square));
}

/// C + iS for t >= 0.
Complex fresnel_upwards(double t) {
  if (is_asymptotic(kPi * t, kPi))
    return Complex{0.5, 0.5} + turned(asymptotic_end(kPi * t, kPi), fresnel_phase(t));
  const int panels = 1 + static_cast<int>(kPi * t * t / (2 * kFinePhase));
  const double step = t / panels;
  Complex sum = 0;
  for (int i = 0; i < panels; ++i)
    sum += turned(by_quadrature(kPi * i * step, kPi, step), fresnel_phase(i * step));
  return sum;
}

Complex fresnel_complex(double t) { return t < 0 ? -fresnel_upwards(-t) : fresnel_upwards(t); }

Complex by_fresnel(double k, double c, double s) {
  if (c < 0) return std::conj(by_fresnel(-k, -c, s));
  const double scale = std::sqrt(kPi / c);
  const double from = k / (c * scale);
  const double to = (k + c * s) / (c * scale);
  return turned(scale * (fresnel_complex(to) - fresnel_complex(from)), -fresnel_phase(from));
}

Complex arc(double k, double s) {
  const double half = k * s / 2;
  const double chord = std::abs(half) < 1e-4 ? s * (1 - half * half / 6) : std::sin(half) / half * s;
  return turned(chord, half);
}

/// Displacement from heading 0.
Complex from_east(double k, double c, double s) {
  if (c == 0) return k == 0 ? Complex{s} : arc(k, s);
  if (half_phase(k, c, s) <= kFinePhase) return by_quadrature(k, c, s);
  const double end = k + c * s;
  const bool away_from_straight = (k > 0) == (end > 0) && is_asymptotic(k, c) && is_asymptotic(end, c);
  if (!away_from_straight) return by_fresnel(k, c, s);
  return turned(asymptotic_end(end, c), (k + c * s / 2) * s) - asymptotic_end(k, c);
}

}  // namespace

FresnelPair fresnel(double t) {
  const Complex pair = fresnel_complex(t);
  return {pair.real(), pair.imag()};
}

Point displacement(const Curve& curve, double s_m) {
  const Complex way =
      turned(from_east(curve.curvature_per_m, curve.sharpness_per_m2, s_m), curve.heading_rad);
  return {way.real(), way.imag()};
}

}  // namespace selion
