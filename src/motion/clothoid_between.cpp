// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "clothoid_guess_table.hpp"
#include "direction.hpp"
#include "displacement.hpp"
#include "selion/core/angle.hpp"
#include "selion/motion/clothoid.hpp"

// Bertolazzi and Frego 2015: over a chord of 1, the heading is a (t^2 - t) + (end - start) t + start, and a
// is the root of the end's height over the chord. Here the first guess is near enough for one step, to whose
// slopes the integrals by parts give more orders at little cost.
namespace selion {
namespace {

constexpr double kPi = std::numbers::pi;

/// Headings against the chord.
struct Angles {
  double start = 0;
  double end = 0;

  [[nodiscard]] double turn() const { return end - start; }
};

/// The end of the curve of length 1, and its first and second slope by a.
struct Shot {
  Point end;
  Point slope;
  Point bend;
};

/// Within 2.5e-5 of the root.
double first_guess(const Angles& angles) {
  const double sum = angles.start + angles.end;
  const double part = sum / (2 * kPi);
  const double other = angles.turn() / (2 * kPi);
  const double x = part * part;
  const double y = other * other;
  std::array<double, kGuessTerms> by_x = kClothoidGuess[kGuessTerms - 1];
  for (std::size_t j = kGuessTerms - 1; j-- > 0;)
    for (std::size_t i = 0; i < kGuessTerms; ++i) by_x[i] = by_x[i] * y + kClothoidGuess[j][i];
  const auto& [c0, c1, c2, c3, c4, c5, c6, c7] = by_x;
  const double xx = x * x;
  return sum * (((c0 + x * c1) + xx * (c2 + x * c3)) + xx * xx * ((c4 + x * c5) + xx * (c6 + x * c7)));
}

Point end_at(const Angles& angles, double a, const EndDirections& ways) {
  return displacement({{}, angles.start, angles.turn() - a, 2 * a, 1}, 1, ways);
}

/// By parts from the end itself: the moments of exp(i heading) over [-1, 1] are
/// a M[n + 1] = -i ([u^n exp] - 2 n M[n - 1]) - turn M[n].
Shot slopes_by_parts(const Angles& angles, double a, Point end, const EndDirections& ways) {
  const double turn = angles.turn();
  const double share = 1 / a;
  const Point odd = ways.last - ways.first;
  const Point even = ways.last + ways.first;
  const auto next = [&](Point rise, Point moment) {
    return share * Point{rise.y_m - turn * moment.x_m, -rise.x_m - turn * moment.y_m};
  };
  const Point m1 = next(odd, end);
  const Point m2 = next(even - 2 * end, m1);
  const Point m3 = next(odd - 4 * m1, m2);
  const Point m4 = next(even - 6 * m2, m3);
  return {end, 0.25 * left_of(m2 - end), -0.0625 * (m4 - 2 * m2 + end)};
}

Shot shoot(const Angles& angles, double a, const EndDirections& ways) {
  // By parts the slope's error grows as 1 / a^2; so near 0 it is a difference.
  constexpr double kLeast = 0.02;
  constexpr double kStep = 1e-4;
  const Point end = end_at(angles, a, ways);
  if (std::abs(a) >= kLeast) return slopes_by_parts(angles, a, end, ways);
  const Point more = end_at(angles, a + kStep, ways) - end;
  const Point less = end_at(angles, a - kStep, ways) - end;
  return {end, 0.5 / kStep * (more - less), 1 / (kStep * kStep) * (more + less)};
}

}  // namespace

Curve clothoid_between(const Pose& from, const Pose& to) {
  // What a step leaves is less than a tenth of its cube, and the more of the distance the farther the curve
  // goes round.
  constexpr double kSmall = 3e-14;
  const Point chord = to.at - from.at;
  const double along = heading_rad(chord);
  const Angles angles{wrapped(from.heading_rad - along), wrapped(to.heading_rad - along)};
  const EndDirections ways{direction({angles.start, 0}), direction({angles.end, 0})};
  double a = first_guess(angles);
  double reach = 1;
  for (int i = 0; i < 30; ++i) {
    const Shot shot = shoot(angles, a, ways);
    const double newton = -shot.end.y_m / shot.slope.y_m;
    const double step = newton - newton * newton * shot.bend.y_m / (2 * shot.slope.y_m);
    a += step;
    reach = shot.end.x_m + step * (shot.slope.x_m + step / 2 * shot.bend.x_m);
    if (std::abs(step * step * step) <= kSmall * std::abs(reach)) break;
  }
  const double length = length_m(chord) / reach;
  if (length == 0) return {from.at, from.heading_rad, 0, 0, 0};
  return {from.at, from.heading_rad, (angles.turn() - a) / length, 2 * a / (length * length), length};
}

}  // namespace selion
