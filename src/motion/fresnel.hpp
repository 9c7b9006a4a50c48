// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace selion {

/// C(t) and S(t): the integrals of cos(pi/2 u^2) and sin(pi/2 u^2) from 0 to t, to 5e-16 at any t (power
/// series below 0.75, else by the auxiliary functions: Abramowitz and Stegun 1964, 7.3.9 to 7.3.13).
struct FresnelPair {
  double c = 0;
  double s = 0;
};
FresnelPair fresnel(double t);

/// f(t) and g(t): what is left of the integrals once their swinging is taken out (Abramowitz and Stegun 1964,
/// 7.3.5): C + i S = (1 + i)/2 - (g + i f) exp(i pi/2 t^2).
struct Auxiliary {
  double f = 0;
  double g = 0;
};
/// @pre 0 <= t <= 4.
Auxiliary auxiliary(double t);
/// pi t f and pi^2 t^3 g, which tend to 1, by 1 / (pi t^2). @pre t >= 4.
Auxiliary far_auxiliary(double inverse);

}  // namespace selion
