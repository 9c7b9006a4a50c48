// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "offer.hpp"
#include "selion/core/angle.hpp"
#include "words.hpp"

namespace selion {
namespace {

using Complex = std::complex<double>;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kLeast_rad = 1e-12;
constexpr double kMost_rad = kTurn - 1e-9;
constexpr double kStart_rad = 0.05;  // below, the chord bends so much that a Newton step leads away
constexpr int kSteps = 20;
constexpr std::size_t kGrid = 12;      // parts of a whole turn
constexpr double kSameRoot_rad = 0.1;  // a start this near to a root found leads there
constexpr double kSlack = 0.3;         // of a triangle's side, for what linear interpolation gets wrong
constexpr double kStride_rad = 0.7;
constexpr double kMet_m = 1e-11;

Complex towards(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

Point point(Complex z) { return {z.real(), z.imag()}; }

Pose mirrored(const Pose& pose) { return {{pose.at.x_m, -pose.at.y_m}, -pose.heading_rad}; }

double cross(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }

/// What the swings left by d1, right by d2, left by d3 miss the goal by, with its derivatives. The heading at
/// the end, as `at_end`, stays as it is: d2 gives way to d1 and d3.
struct Miss {
  Complex value;
  Complex by_first;
  Complex by_third;
};

Miss miss_of(const ThreeSwings& d, Complex at_end, Complex goal, const Swings& swings) {
  const Complex along1 = towards(d[0] / 2);
  const Complex half2 = towards(d[1] / 2);
  const Complex half3 = towards(d[2] / 2);
  const Chord c1 = swings.chord(d[0], point(along1));
  const Chord c2 = swings.chord(d[1], point(half2));
  const Chord c3 = swings.chord(d[2], point(half3));
  const Complex along2 = along1 * along1 * std::conj(half2);
  const Complex along3 = at_end * std::conj(half3);
  return {c1.length_m * along1 + c2.length_m * along2 + c3.length_m * along3 - goal,
          Complex{c1.slope_m_per_rad, c1.length_m / 2} * along1 +
              Complex{c2.slope_m_per_rad, c2.length_m / 2} * along2,
          Complex{c2.slope_m_per_rad, -c2.length_m / 2} * along2 +
              Complex{c3.slope_m_per_rad, -c3.length_m / 2} * along3};
}

/// A Newton step of `by_rad` taken in the deflection's square root, in which a small swing's length is
/// smooth; cut to half a turn and to what a swing may be.
double stepped(double deflection_rad, double by_rad) {
  const double root = std::sqrt(deflection_rad);
  const double next = std::clamp(root + by_rad / (2 * root), root / 8, std::sqrt(kMost_rad));
  return std::clamp(next * next, std::max(deflection_rad - kStride_rad, kLeast_rad),
                    deflection_rad + kStride_rad);
}

/// Left, right, left; the deflections as magnitudes.
std::optional<ThreeSwings> polished_left(const ThreeSwings& start, const Pose& goal, const Swings& swings) {
  const Complex target{goal.at.x_m, goal.at.y_m};
  const double drawn = start[0] - start[1] + start[2];
  const double turned = drawn - wrapped(drawn - goal.heading_rad);
  ThreeSwings d{std::clamp(start[0], kStart_rad, kMost_rad), 0, std::clamp(start[2], kStart_rad, kMost_rad)};
  const Complex at_end = towards(goal.heading_rad);
  double miss_before_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    d[1] = d[0] + d[2] - turned;
    if (d[1] < 0) {  // the outer swings give way
      d[0] = std::min(kMost_rad, d[0] - d[1] / 2 + kLeast_rad);
      d[2] = std::min(kMost_rad, d[2] - d[1] / 2 + kLeast_rad);
      d[1] = d[0] + d[2] - turned;
    }
    if (!(d[1] >= 0 && d[1] <= kMost_rad && d[0] <= kMost_rad && d[2] <= kMost_rad)) return std::nullopt;
    const Miss miss = miss_of(d, at_end, target, swings);
    const double miss_m = std::abs(miss.value.real()) + std::abs(miss.value.imag());
    if (miss_m < kMet_m) return d;
    if (i % 4 == 3) {
      if (miss_m > miss_before_m) return std::nullopt;
      miss_before_m = miss_m;
    }
    const double scale = cross(miss.by_first, miss.by_third);
    d[0] = stepped(d[0], -cross(miss.value, miss.by_third) / scale);
    d[2] = stepped(d[2], -cross(miss.by_first, miss.value) / scale);
  }
  return std::nullopt;
}

bool near(const ThreeSwings& a, const ThreeSwings& b, double within_rad) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < within_rad;
}

void add_polished(std::vector<ThreeSwings>& found, const ThreeSwings& start, const Pose& goal,
                  const Swings& swings) {
  const auto has = [&found](const ThreeSwings& triple, double within_rad) {
    return std::any_of(found.begin(), found.end(),
                       [&](const ThreeSwings& other) { return near(other, triple, within_rad); });
  };
  if (has(start, kSameRoot_rad)) return;
  const auto triple = polished_left(start, goal, swings);
  if (triple && !has(*triple, 1e-7)) found.push_back(*triple);
}

/// The misses over a grid of the first and third deflections. The third one's grid is shifted so that the
/// second, which follows from them, is a whole number of steps everywhere: its jump from a whole turn to 0
/// then runs along the diagonals that cut the cells into triangles, and never through one.
class Grid {
 public:
  Grid(const Pose& goal, const Swings& swings)
      : far_m_{4 * (kStep * length_m(swings.centre()) + swings.chord(kStep).length_m)} {
    const double psi = whole_turns_off(goal.heading_rad);
    shift_ = std::min(static_cast<std::size_t>(psi / kStep), kGrid - 1);
    const double third_least = psi - kStep * static_cast<double>(shift_) - kStep;
    const Complex target{goal.at.x_m, goal.at.y_m};
    // Below 0 a swing goes back as far as one to the other side goes ahead: smooth in the deflection's signed
    // root.
    const auto way = [&swings](double d) {
      const Complex along = towards(std::abs(d) / 2);
      const double chord = swings.chord(std::abs(d), point(along)).length_m;
      return d < 0 ? -chord * std::conj(along) : chord * along;
    };
    const Complex at_end = towards(goal.heading_rad);
    std::array<Complex, kGrid + 1> ways;
    for (std::size_t i = 0; i <= kGrid; ++i) {
      const double d = kStep * static_cast<double>(i);
      first_root_[i] = std::sqrt(d);
      ways[i] = way(d);
    }
    for (std::size_t i = 0; i <= kGrid; ++i) {
      const Complex ahead = towards(kStep * static_cast<double>(i));
      for (std::size_t k = 0; k <= kGrid; ++k) second_end_[i][k] = ways[i] + ahead * std::conj(ways[k]);
    }
    for (std::size_t j = 0; j < third_start_.size(); ++j) {
      const double d = third_least + kStep * static_cast<double>(j);
      third_root_[j] = std::copysign(std::sqrt(std::abs(d)), d);
      third_start_[j] = target - at_end * std::conj(way(d));
    }
  }

  /// Triples near which the miss may vanish: where it does so on a triangle, taken as linear there.
  [[nodiscard]] std::vector<ThreeSwings> starts() const {
    std::vector<ThreeSwings> starts;
    for (std::size_t i = 0; i < kGrid; ++i) {
      for (std::size_t j = 0; j + 1 < third_start_.size(); ++j) {
        // Steps of the second deflection at the near corner and at the diagonal; j counts from one step below
        // 0.
        const std::size_t low = (i + j + 2 * kGrid - 1 - shift_) % kGrid;
        const std::size_t high = (low + 1) % kGrid;
        const Complex near = miss(i, j, low);
        if (std::abs(near.real()) + std::abs(near.imag()) > far_m_) continue;
        add(starts, {i, j, low, 1}, {near, miss(i + 1, j, low + 1), miss(i, j + 1, low + 1)});
        add(starts, {i + 1, j + 1, high + 1, -1},
            {miss(i + 1, j + 1, high + 1), miss(i, j + 1, high), miss(i + 1, j, high)});
      }
    }
    return starts;
  }

 private:
  static constexpr double kStep = kTurn / kGrid;

  [[nodiscard]] Complex miss(std::size_t i, std::size_t j, std::size_t second) const {
    return third_start_[j] - second_end_[i][second];
  }

  /// A triangle by its right angle; its legs of one step go up or down, by `direction`.
  struct Triangle {
    std::size_t first;
    std::size_t third;
    std::size_t second;
    int direction;
  };

  void add(std::vector<ThreeSwings>& starts, const Triangle& at,
           const std::array<Complex, 3>& corners) const {
    const Complex along = corners[1] - corners[0];
    const Complex across = corners[2] - corners[0];
    const double scale = cross(along, across);
    const double size = std::abs(scale);
    const double s_size = std::copysign(1.0, -scale) * cross(corners[0], across);
    const double t_size = std::copysign(1.0, -scale) * cross(along, corners[0]);
    if (!(s_size >= -kSlack * size && t_size >= -kSlack * size && s_size + t_size <= (1 + kSlack) * size))
      return;
    if (size == 0) return;
    const double s = s_size / size;
    const double t = t_size / size;
    const auto up = static_cast<std::size_t>(at.direction);  // -1 wraps round to one down
    const double first = between(first_root_[at.first], first_root_[at.first + up], s);
    const double third = between(third_root_[at.third], third_root_[at.third + up], t);
    starts.push_back({first, kStep * (static_cast<double>(at.second) + at.direction * (s + t)), third});
  }

  static double between(double root, double next_root, double share) {
    const double at = root + share * (next_root - root);
    return at * std::abs(at);
  }

  double far_m_ = 0;  // a larger miss does not vanish within the cell
  std::size_t shift_ = 0;
  std::array<double, kGrid + 1>
      first_root_;  // of the deflections, signed: a small swing's length is linear in it
  std::array<double, kGrid + 2> third_root_;
  std::array<std::array<Complex, kGrid + 1>, kGrid + 1>
      second_end_;  // by the first and the second deflection
  std::array<Complex, kGrid + 2> third_start_;
};

}  // namespace

std::optional<ThreeSwings> polished(const ThreeSwings& start, const Pose& goal, const Swings& swings) {
  const double side = start[0] < 0 || start[1] > 0 ? -1 : 1;
  const auto magnitudes = polished_left({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])},
                                        side > 0 ? goal : mirrored(goal), swings);
  if (!magnitudes) return std::nullopt;
  return ThreeSwings{side * (*magnitudes)[0], -side * (*magnitudes)[1], side * (*magnitudes)[2]};
}

std::vector<ThreeSwings> three_swings(const Pose& goal, int side, const Swings& swings) {
  if (length_m(goal.at) > 6 * length_m(swings.centre())) return {};
  const Pose seen = side > 0 ? goal : mirrored(goal);
  std::vector<ThreeSwings> found;
  for (const ThreeSwings& start : Grid{seen, swings}.starts()) add_polished(found, start, seen, swings);
  const double s = side;
  for (ThreeSwings& triple : found) triple = {s * triple[0], -s * triple[1], s * triple[2]};
  return found;
}

void draw_swings(Drawn& drawn, const ThreeSwings& deflections, const Swings& swings) {
  for (const double deflection : deflections) draw_swing(drawn, deflection, swings);
}

}  // namespace selion
