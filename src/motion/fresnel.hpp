// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/path.hpp"

namespace selion {

/// C(t) and S(t): the integrals of cos(pi/2 u^2) and sin(pi/2 u^2) from 0 to t, to 2e-15 for |t| <= 50.
struct FresnelPair {
  double c = 0;
  double s = 0;
};
FresnelPair fresnel(double t);

/// From the start of the curve to its point at `s_m` (which may lie outside [0, length]), in the curve's
/// frame of reference. The error stays near 1e-16 of the way driven, with no seam between lines, arcs and
/// clothoids.
Point displacement(const Curve& curve, double s_m);

}  // namespace selion
