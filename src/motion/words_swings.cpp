// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "direction.hpp"
#include "offer.hpp"
#include "selion/core/angle.hpp"
#include "words.hpp"

namespace selion {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::size_t kParts = Swings::kParts;
constexpr double kStep_rad = kTurn / kParts;
constexpr double kLeast_rad = 1e-12;
constexpr double kMost_rad = kTurn - 1e-9;
constexpr double kStart_rad = 0.05;  // below, the chord bends so much that a Newton step leads away
constexpr int kSteps = 20;
constexpr double kSameRoot_rad = 0.1;  // a start this near to a root found leads there
constexpr double kSlack = 0.3;         // of a triangle's side, for what linear interpolation gets wrong
constexpr double kStride_rad = 0.7;
// A start leads to a way shorter than its own by a fifth at most, and than its cell by a twentieth.
constexpr double kLeastOfGuess = 0.8;
constexpr double kLeastOfCorner = 0.95;
constexpr double kMet_m = 1e-8;
constexpr double kFalls = 0.9;  // in two steps, at least
constexpr double kSettled_m = 1e-13;

/// What the swings left by d1, right by d2, left by d3 miss the goal by, with its derivatives. The heading at
/// the end, as `at_end`, stays as it is: d2 gives way to d1 and d3.
struct Miss {
  Point value;
  Point by_first;
  Point by_third;
};

Miss miss_of(const ThreeSwings& d, Point at_end, Point goal, const Swings& swings) {
  const Point along1 = direction({d[0] / 2, 0});
  const Point half2 = direction({d[1] / 2, 0});
  const Point half3 = direction({d[2] / 2, 0});
  const Chord c1 = swings.chord(d[0], along1);
  const Chord c2 = swings.chord(d[1], half2);
  const Chord c3 = swings.chord(d[2], half3);
  const Point along2 = turned(turned(along1, along1), mirrored(half2));
  const Point along3 = turned(at_end, mirrored(half3));
  const Point slope2 = c2.slope_m_per_rad * along2;
  const Point across2 = c2.length_m / 2 * left_of(along2);
  return {c1.length_m * along1 + c2.length_m * along2 + c3.length_m * along3 - goal,
          c1.slope_m_per_rad * along1 + c1.length_m / 2 * left_of(along1) + slope2 + across2,
          slope2 - across2 + c3.slope_m_per_rad * along3 - c3.length_m / 2 * left_of(along3)};
}

/// A Newton step of `by_rad` taken in the deflection's square root, in which a small swing's length is
/// smooth; cut to half a turn and to what a swing may be.
double stepped(double deflection_rad, double by_rad) {
  const double root = std::sqrt(deflection_rad);
  const double next = std::clamp(root + by_rad / (2 * root), root / 8, std::sqrt(kMost_rad));
  return std::clamp(next * next, std::max(deflection_rad - kStride_rad, kLeast_rad),
                    deflection_rad + kStride_rad);
}

/// Sets the second deflection so that all three turn by `turned_rad`; false where no swing does.
bool second_follows(ThreeSwings& d, double turned_rad) {
  d[1] = d[0] + d[2] - turned_rad;
  if (d[1] < 0) {  // the outer swings give way
    d[0] = std::min(kMost_rad, d[0] - d[1] / 2 + kLeast_rad);
    d[2] = std::min(kMost_rad, d[2] - d[1] / 2 + kLeast_rad);
    d[1] = d[0] + d[2] - turned_rad;
  }
  return d[1] >= 0 && d[1] <= kMost_rad && d[0] <= kMost_rad && d[2] <= kMost_rad;
}

/// The length of a small swing grows with the root of its deflection: what is rounded away between the outer
/// swings would move the end by more than they do. A heading missed by as much is nothing.
void mend_small_second(ThreeSwings& d, Point at_end, Point goal, const Swings& swings) {
  constexpr double kSmall_rad = 1e-4;
  if (d[1] <= 0 || d[1] > kSmall_rad) return;
  const Point half1 = direction({d[0] / 2, 0});
  const Point along = turned(turned(half1, half1), mirrored(direction({d[1] / 2, 0})));
  const Point off = miss_of(d, at_end, goal, swings).value;
  d[1] = std::max(0.0, d[1] - dot(off, along) / swings.chord(d[1], along).slope_m_per_rad);
}

std::optional<ThreeSwings> settled(ThreeSwings d, double turned_rad, Point at_end, Point goal,
                                   const Swings& swings) {
  d[1] = d[0] + d[2] - turned_rad;
  if (d[1] < 0) return std::nullopt;
  mend_small_second(d, at_end, goal, swings);
  return d;
}

/// Left, right, left; the deflections as magnitudes.
std::optional<ThreeSwings> polished_left(const ThreeSwings& start, const Pose& goal, const Swings& swings) {
  const double drawn = start[0] - start[1] + start[2];
  const double turned = drawn - wrapped(drawn - goal.heading_rad);
  ThreeSwings d{std::clamp(start[0], kStart_rad, kMost_rad), 0, std::clamp(start[2], kStart_rad, kMost_rad)};
  const Point at_end = unit(goal.heading_rad);
  double miss_before_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    if (!second_follows(d, turned)) return std::nullopt;
    const Miss miss = miss_of(d, at_end, goal.at, swings);
    const double miss_m = std::abs(miss.value.x_m) + std::abs(miss.value.y_m);
    if (miss_m < kSettled_m) return d;
    const bool met = miss_m < kMet_m;
    if (i % 2 == 1) {  // Newton's steps get there fast or not at all
      if (i > 1 && miss_m > kFalls * miss_before_m) return std::nullopt;
      miss_before_m = miss_m;
    }
    const double scale = cross(miss.by_first, miss.by_third);
    d[0] = stepped(d[0], -cross(miss.value, miss.by_third) / scale);
    d[2] = stepped(d[2], -cross(miss.by_first, miss.value) / scale);
    if (met) return settled(d, turned, at_end, goal.at, swings);  // with one more step, down to rounding
  }
  return std::nullopt;
}

bool near(const ThreeSwings& a, const ThreeSwings& b, double within_rad) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < within_rad;
}

/// Steps of the second deflection at the lower corner of a cell: it follows from the first and the third.
constexpr std::size_t second_of(std::size_t diagonal, std::size_t shift) {
  return (diagonal + 2 * kParts - 1 - shift) % kParts;  // the third counts from one step below 0
}

/// The least steps of the three deflections on a diagonal: beyond its middle the second one may begin anew.
constexpr std::size_t steps_on(std::size_t diagonal, std::size_t shift) {
  return diagonal + second_of(diagonal, shift) % (kParts - 1);
}

/// The diagonals by the least deflections on them, for each shift.
constexpr auto kByDeflections = [] {
  std::array<std::array<std::size_t, ThreeSwingSearch::kDiagonals>, kParts> orders{};
  for (std::size_t shift = 0; shift < kParts; ++shift) {
    auto& order = orders[shift];
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [shift](std::size_t a, std::size_t b) {
      const std::size_t steps = steps_on(a, shift);
      const std::size_t other = steps_on(b, shift);
      return steps < other || (steps == other && a < b);
    });
  }
  return orders;
}();

double length_between(double deflection_rad, const Swings& swings) {
  return deflection_rad > 0 ? swings.length_m(deflection_rad) : 0;
}

double signed_root(double d) { return std::copysign(std::sqrt(std::abs(d)), d); }

/// Deflections are interpolated by their signed roots: a small swing's length is linear in those.
double between(double deflection_rad, double next_rad, double share) {
  const double root = signed_root(deflection_rad);
  const double at = root + share * (signed_root(next_rad) - root);
  return at * std::abs(at);
}

double first_rad(std::size_t i) { return kStep_rad * static_cast<double>(i); }

}  // namespace

// The third deflection's grid is shifted so that the second, which follows from the other two, is a whole
// number of steps everywhere: its jump from a whole turn to 0 then runs along the diagonals that cut the
// cells into triangles, and never through one.
ThreeSwingSearch::ThreeSwingSearch(const Pose& goal, int side, const Swings& swings)
    : swings_{&swings}, goal_{side > 0 ? goal : mirrored(goal)}, side_{side} {
  far_m_ = 4 * (kStep_rad * length_m(swings.centre()) + swings.chord(kStep_rad).length_m);
  const double psi = whole_turns_off(goal_.heading_rad);
  shift_ = std::min(static_cast<std::size_t>(psi / kStep_rad), kParts - 1);
  third_least_rad_ = psi - kStep_rad * static_cast<double>(shift_) - kStep_rad;
  const Point at_end = unit(goal_.heading_rad);
  Point half = unit(third_least_rad_ / 2);
  const Point half_step = unit(kStep_rad / 2);
  for (std::size_t j = 0; j < third_start_.size(); ++j) {
    // Below 0 a swing goes back as far as one to the other side goes ahead: smooth in its signed root.
    const double d = third_least_rad_ + first_rad(j);
    const Point along = d < 0 ? mirrored(half) : half;
    const double chord = swings.chord(std::abs(d), along).length_m;
    const Point way = d < 0 ? -chord * mirrored(along) : chord * along;
    third_start_[j] = goal_.at - turned(at_end, mirrored(way));
    half = turned(half, half_step);
  }
}

Point ThreeSwingSearch::miss(std::size_t first, std::size_t third, std::size_t second) const {
  return third_start_[third] - swings_->two_swings(first, second);
}

std::optional<double> ThreeSwingSearch::least_m(std::size_t rank) const {
  if (rank >= kDiagonals) return std::nullopt;
  const std::size_t diagonal = kByDeflections[shift_][rank];
  const auto steps = static_cast<double>(steps_on(diagonal, shift_));
  // One swing by the sum of the deflections is shorter than any that add up to it.
  return kLeastOfCorner * length_between(kStep_rad * steps + third_least_rad_, *swings_);
}

/// A triangle by its right angle; its legs of one step go up or down, by `direction`.
struct ThreeSwingSearch::Triangle {
  std::size_t first;
  std::size_t third;
  std::size_t second;
  int direction;
};

void ThreeSwingSearch::add_starts(std::vector<Start>& starts, std::size_t rank) const {
  const std::size_t diagonal = kByDeflections[shift_][rank];
  const std::size_t low = second_of(diagonal, shift_);
  const std::size_t high = (low + 1) % kParts;
  for (std::size_t i = diagonal > kParts ? diagonal - kParts : 0; i < kParts && i <= diagonal; ++i) {
    const std::size_t j = diagonal - i;
    const Point near = miss(i, j, low);
    if (std::abs(near.x_m) + std::abs(near.y_m) > far_m_) continue;
    add_start(starts, {i, j, low, 1}, {near, miss(i + 1, j, low + 1), miss(i, j + 1, low + 1)});
    add_start(starts, {i + 1, j + 1, high + 1, -1},
              {miss(i + 1, j + 1, high + 1), miss(i, j + 1, high), miss(i + 1, j, high)});
  }
}

void ThreeSwingSearch::add_start(std::vector<Start>& starts, const Triangle& at,
                                 const Corners& corners) const {
  const Point along = corners[1] - corners[0];
  const Point across = corners[2] - corners[0];
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
  const double third_rad = third_least_rad_ + first_rad(at.third);
  const double first = between(first_rad(at.first), first_rad(at.first + up), s);
  const double third = between(third_rad, third_rad + at.direction * kStep_rad, t);
  const double second = kStep_rad * (static_cast<double>(at.second) + at.direction * (s + t));
  const std::size_t down = at.direction > 0 ? 0 : 1;
  const double corner = length_between(first_rad(at.first - down), *swings_) +
                        length_between(first_rad(at.second - down), *swings_) +
                        length_between(third_rad - kStep_rad * static_cast<double>(down), *swings_);
  const double about =
      length_between(first, *swings_) + length_between(second, *swings_) + length_between(third, *swings_);
  starts.push_back({{first, second, third}, std::max(kLeastOfCorner * corner, kLeastOfGuess * about)});
}

std::optional<ThreeSwings> ThreeSwingSearch::found(const Start& start) {
  const auto known = [this](const ThreeSwings& triple, double within_rad) {
    return std::any_of(known_.begin(), known_.end(),
                       [&](const ThreeSwings& other) { return near(other, triple, within_rad); });
  };
  if (known(start.near_rad, kSameRoot_rad)) return std::nullopt;
  const auto triple = polished_left(start.near_rad, goal_, *swings_);
  if (!triple || known(*triple, 1e-7)) return std::nullopt;
  known_.push_back(*triple);
  const double s = side_;
  return ThreeSwings{s * (*triple)[0], -s * (*triple)[1], s * (*triple)[2]};
}

std::optional<ThreeSwings> polished(const ThreeSwings& start, const Pose& goal, const Swings& swings) {
  const double side = start[0] < 0 || start[1] > 0 ? -1 : 1;
  const auto magnitudes = polished_left({std::abs(start[0]), std::abs(start[1]), std::abs(start[2])},
                                        side > 0 ? goal : mirrored(goal), swings);
  if (!magnitudes) return std::nullopt;
  return ThreeSwings{side * (*magnitudes)[0], -side * (*magnitudes)[1], side * (*magnitudes)[2]};
}

}  // namespace selion
