// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "offer.hpp"
#include "root.hpp"
#include "words.hpp"

namespace selion {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kNoSwing_rad = 1e-13;  // a swing by less is rounding
constexpr double kNoLine_m = 1e-11;
constexpr double kSeam_rad = 1e-9;  // beyond its bounds, so that no root falls between two intervals

/// The first deflection u determines the second, v, and where the straight between them would have to lie.
struct Word {
  Pose goal;
  double first_side;
  double second_side;
  const Swings* swings;

  [[nodiscard]] double second(double u) const {
    return whole_turns_off(second_side * (goal.heading_rad - first_side * u));
  }
  /// How far left of the straight after the first swing the second one would have to begin.
  [[nodiscard]] double miss_m(double u) const {
    const double v = second(u);
    const double seen_left = goal.at.y_m * std::cos(u) - first_side * goal.at.x_m * std::sin(u);
    return -first_side * swings->chord(u).length_m * std::sin(u / 2) +
           second_side * swings->chord(v).length_m * std::sin(v / 2) - seen_left;
  }
  [[nodiscard]] double line_m(double u, double v) const {
    const double seen_ahead = goal.at.x_m * std::cos(u) + first_side * goal.at.y_m * std::sin(u);
    return seen_ahead - swings->chord(u).length_m * std::cos(u / 2) -
           swings->chord(v).length_m * std::cos(v / 2);
  }
};

double snapped(double angle_rad) {
  return angle_rad < kNoSwing_rad || angle_rad > kTurn - kNoSwing_rad ? 0 : angle_rad;
}

void add(std::vector<SwingLineSwing>& words, const Word& word, double root) {
  const double u = snapped(root);
  const double v = snapped(word.second(u));
  const double line = word.line_m(u, v);
  if (line < -kNoLine_m) return;
  words.push_back({word.first_side * u, line < kNoLine_m ? 0 : line, word.second_side * v});
}

/// Roots between two neighbouring samples; a dip towards 0 between three is looked into at the vertex of its
/// parabola.
class Scan {
 public:
  Scan(const Word& word, std::vector<SwingLineSwing>& words) : word_{word}, words_{words} {}

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

  const Word& word_;
  std::vector<SwingLineSwing>& words_;
  RootEnd a_;
  RootEnd b_;
  int seen_ = 0;
};

/// Where both swings reach the curvature limit, the miss is A cos u + B sin u + C.
void add_full(std::vector<SwingLineSwing>& words, const Word& word, double from, double to) {
  const Point centre = word.swings->centre();
  const double s = word.first_side;
  const double t = word.second_side;
  const double psi = word.goal.heading_rad;
  // chord(w) sin(w/2) = b + a sin w - b cos w for w = u and for v = t psi - s t u.
  const double sin_v = std::sin(t * psi);
  const double cos_v = std::cos(psi);
  const double a = centre.x_m;
  const double b = centre.y_m;
  const double cosine = s * b + t * (a * sin_v - b * cos_v) - word.goal.at.y_m;
  const double sine = -s * a - s * (a * cos_v + b * sin_v) + s * word.goal.at.x_m;
  const double constant = (t - s) * b;
  const double reach = std::hypot(cosine, sine);
  if (!(std::abs(constant) <= reach)) return;
  const double middle = std::atan2(sine, cosine);
  const double spread = std::acos(-constant / reach);
  for (const double u : {whole_turns_off(middle - spread), whole_turns_off(middle + spread)}) {
    if (u >= from - kSeam_rad && u <= to + kSeam_rad) add(words, word, u);
  }
}

}  // namespace

std::vector<SwingLineSwing> swing_line_swings(const Pose& goal, int first_side, int second_side,
                                              const Swings& swings) {
  const Word word{goal, static_cast<double>(first_side), static_cast<double>(second_side), &swings};
  const double full = std::min(swings.full_rad(), kTurn);
  const double seam = whole_turns_off(first_side * goal.heading_rad);  // v = 0
  const double second_full =
      whole_turns_off(first_side * (goal.heading_rad - second_side * full));  // v = full
  std::array<double, 5> bounds{0, full, seam, second_full, kTurn};
  std::sort(bounds.begin(), bounds.end());

  std::vector<SwingLineSwing> words;
  Scan scan{word, words};
  scan.begin_at(0);
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const double width = bounds[i] - bounds[i - 1];
    if (width <= 0) continue;
    const double middle = bounds[i - 1] + width / 2;
    if (middle >= full && word.second(middle) >= full) {
      add_full(words, word, bounds[i - 1], bounds[i]);
      scan.begin_at(bounds[i]);
      continue;
    }
    const int steps = std::max(3, static_cast<int>(std::ceil(width * 4)));
    for (int k = 1; k <= steps; ++k) scan.see(bounds[i - 1] + width * k / steps);
  }
  return words;
}

}  // namespace selion
