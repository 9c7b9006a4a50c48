// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "direction.hpp"
#include "offer.hpp"
#include "root.hpp"
#include "words.hpp"

namespace selion {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kNoSwing_rad = 1e-13;  // a swing by less is rounding
constexpr double kNoLine_m = 1e-13;
constexpr double kSeam_rad = 1e-9;  // beyond its bounds, so that no root falls between two intervals

/// The first deflection u determines the second, v, and where the straight between them would have to lie.
class Line {
 public:
  Line(const Pose& goal, int first, int second, const Swings& swings)
      : first_side{static_cast<double>(first)},
        second_side{static_cast<double>(second)},
        goal_{goal.at.x_m, first * goal.at.y_m},
        heading_rad_{first * goal.heading_rad},
        half_heading_{unit(heading_rad_ / 2)},
        swings_{swings},
        change_m_{selion::length_m(goal.at) +
                  6 * swings.limits().curvature_per_m / swings.limits().sharpness_per_m2 +
                  2 / swings.limits().curvature_per_m} {}

  [[nodiscard]] double second(double u) const {
    return whole_turns_off(first_side * second_side * (heading_rad_ - u));
  }

  /// How far left of the straight after the first swing the second one would have to begin, and how long the
  /// straight would be.
  struct Fit {
    double miss_m;
    double line_m;
    Point half_u;
    Point half_v;
  };
  /// Seen from the side to which the first swing turns, as if that were the left.
  [[nodiscard]] Fit fit(double u, double v) const {
    const Point half_u = direction({u / 2, 0});
    Point half_v = turned(half_heading_, mirrored(half_u));
    if (first_side != second_side) half_v.y_m = -half_v.y_m;
    if (half_v.y_m < 0) half_v = -1 * half_v;  // v / 2 lies in [0, pi)
    if (v == 0) half_v = {1, 0};
    const Point seen = turned(mirrored(turned(half_u, half_u)), goal_);
    const double first_m = swings_.chord(u, half_u).length_m;
    const double second_m = swings_.chord(v, half_v).length_m;
    return {-first_m * half_u.y_m + first_side * second_side * second_m * half_v.y_m - seen.y_m,
            seen.x_m - first_m * half_u.x_m - second_m * half_v.x_m, half_u, half_v};
  }
  [[nodiscard]] double miss_m(double u) const { return fit(u, second(u)).miss_m; }

  /// May the miss vanish within `half_rad` of u? Not where it is larger than all that it can change: per
  /// radian by the goal's distance and, for each swing, by 3 ramps or the centre's distance at most.
  [[nodiscard]] bool may_meet(double u, double half_rad) const {
    return std::abs(miss_m(u)) <= half_rad * change_m_;
  }

  /// Where both swings reach the curvature limit, the miss is A cos u + B sin u + C: its two zeros.
  [[nodiscard]] std::optional<std::array<double, 2>> full_roots() const {
    const Point centre = swings_.centre();
    const double t = first_side * second_side;
    // chord(w) sin(w/2) = b + a sin w - b cos w for w = u and for v = t (psi - u).
    const Point psi = turned(half_heading_, half_heading_);
    const double cosine = centre.y_m + t * (t * centre.x_m * psi.y_m - centre.y_m * psi.x_m) - goal_.y_m;
    const double sine = -centre.x_m - (centre.x_m * psi.x_m + t * centre.y_m * psi.y_m) + goal_.x_m;
    const double constant = (t - 1) * centre.y_m;
    const double reach = std::sqrt(cosine * cosine + sine * sine);
    if (!(std::abs(constant) <= reach)) return std::nullopt;
    const double middle = std::atan2(sine, cosine);
    const double spread = std::acos(-constant / reach);
    return std::array{whole_turns_off(middle - spread), whole_turns_off(middle + spread)};
  }

  double first_side;
  double second_side;

 private:
  Point goal_;  // mirrored where the first swing is one to the right
  double heading_rad_;
  Point half_heading_;
  const Swings& swings_;
  double change_m_;  // of the miss, per radian, at most
};

double snapped(double angle_rad) {
  return angle_rad < kNoSwing_rad || angle_rad > kTurn - kNoSwing_rad ? 0 : angle_rad;
}

void add(std::vector<Word>& words, const Line& word, double root) {
  const double u = snapped(root);
  const double v = snapped(word.second(u));
  const Line::Fit fit = word.fit(u, v);
  const Deflection first{word.first_side * u, {fit.half_u.x_m, word.first_side * fit.half_u.y_m}};
  const Deflection second{word.second_side * v, {fit.half_v.x_m, word.second_side * fit.half_v.y_m}};
  const double line_m = std::abs(fit.line_m) < kNoLine_m ? 0 : fit.line_m;
  words.push_back({.swings = {first, second, {}}, .line_m = line_m});
}

void add_within(std::vector<Word>& words, const Line& word, const std::array<double, 2>& roots, double from,
                double to) {
  for (const double u : roots)
    if (u >= from - kSeam_rad && u <= to + kSeam_rad) add(words, word, u);
}

/// Roots between two neighbouring samples; a dip towards 0 between three is looked into at the vertex of its
/// parabola.
class Scan {
 public:
  Scan(const Line& word, std::vector<Word>& words) : word_{word}, words_{words} {}

  void begin_at(double u) {
    seen_ = 0;
    see(u);
  }

  void see(double u) {
    const RootEnd next{u, word_.miss_m(u)};
    if (seen_ > 0 && (next.y > 0) != (b_.y > 0)) {
      solve(b_, next);
    } else if (seen_ > 1 && (a_.y > 0) == (b_.y > 0) && std::abs(b_.y) < std::abs(a_.y) &&
               std::abs(b_.y) < std::abs(next.y)) {
      look_between(next);
    }
    a_ = b_;
    b_ = next;
    ++seen_;
  }

 private:
  void solve(const RootEnd& from, const RootEnd& to) {
    add(words_, word_, root_between(from, to, [this](double u) { return word_.miss_m(u); }));
  }

  void look_between(const RootEnd& c) {
    const double left = (b_.y - a_.y) / (b_.x - a_.x);
    const double right = (c.y - b_.y) / (c.x - b_.x);
    const double bend = (right - left) / (c.x - a_.x);
    const double x = (a_.x + b_.x) / 2 - left / (2 * bend);
    if (!(x > a_.x && x < c.x)) return;
    const RootEnd vertex{x, word_.miss_m(x)};
    if ((vertex.y > 0) == (b_.y > 0)) return;
    solve(vertex.x < b_.x ? a_ : b_, vertex);
    solve(vertex, vertex.x < b_.x ? b_ : c);
  }

  const Line& word_;
  std::vector<Word>& words_;
  RootEnd a_;
  RootEnd b_;
  int seen_ = 0;
};

void see_between(Scan& scan, double from, double width) {
  const int steps = std::max(3, static_cast<int>(std::ceil(width * 4)));
  for (int k = 1; k <= steps; ++k) scan.see(from + width * k / steps);
}

}  // namespace

void add_swing_line_swings(std::vector<Word>& words, const Pose& goal, int first_side, int second_side,
                           const Swings& swings) {
  const auto before = static_cast<std::ptrdiff_t>(words.size());
  add_swings_on_a_line(words, goal, first_side, second_side, swings);
  words.erase(
      std::remove_if(words.begin() + before, words.end(), [](const Word& word) { return word.line_m < 0; }),
      words.end());
}

void add_swings_on_a_line(std::vector<Word>& words, const Pose& goal, int first_side, int second_side,
                          const Swings& swings) {
  const Line word{goal, first_side, second_side, swings};
  const double full = std::min(swings.full_rad(), kTurn);
  const double seam = whole_turns_off(first_side * goal.heading_rad);  // v = 0
  const double second_full =
      whole_turns_off(first_side * (goal.heading_rad - second_side * full));  // v = full
  std::array<double, 5> bounds{0, full, seam, second_full, kTurn};
  std::sort(bounds.begin(), bounds.end());

  const auto full_roots = word.full_roots();
  Scan scan{word, words};
  bool joined = false;  // the last interval was scanned too
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const double width = bounds[i] - bounds[i - 1];
    if (width <= 0) continue;
    const double middle = bounds[i - 1] + width / 2;
    const bool full_swings = middle >= full && word.second(middle) >= full;
    if (full_swings && full_roots) add_within(words, word, *full_roots, bounds[i - 1], bounds[i]);
    if (full_swings || !word.may_meet(middle, width / 2)) {
      joined = false;
      continue;
    }
    if (!joined) scan.begin_at(bounds[i - 1]);
    joined = true;
    see_between(scan, bounds[i - 1], width);
  }
}

}  // namespace selion
