// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace selion {
namespace {

/// Half of the squared distance at a station, and its derivatives.
struct Gap {
  double half_square = 0;
  double slope = 0;
  double bend = 0;
  double across = 0;  ///< from the place to the curve, along the curve's left
  double distance_m = 0;
};

struct Span {
  double from = 0;
  double to = 0;
};

struct Best {
  double station = 0;
  double half_square = std::numeric_limits<double>::infinity();
};

class Search {
 public:
  Search(const Curve& curve, Point place, double within) : curve_{curve}, place_{place} {
    best_.half_square = within;
  }

  /// None where nothing lies nearer than `within`.
  std::optional<double> run() {
    visit(0);
    visit(curve_.length_m);
    within({0, curve_.length_m});
    return found_ ? std::optional{best_.station} : std::nullopt;
  }
  [[nodiscard]] double half_square() const { return best_.half_square; }

 private:
  Gap visit(double s) {
    const CurveState state = state_at(curve_, s);
    const Point way = state.at - place_;
    const Point ahead = unit(state.heading_rad);
    const double across = cross(ahead, way);
    const double square = dot(way, way);
    if (square / 2 < best_.half_square) {
      best_ = {s, square / 2};
      found_ = true;
    }
    return {square / 2, dot(way, ahead), 1 + state.curvature_per_m * across, across, std::sqrt(square)};
  }

  /// How much the second derivative may differ from its value in the middle: the third is c across - k^2
  /// slope.
  [[nodiscard]] double bend_margin(Span span, double distance) const {
    const double half = (span.to - span.from) / 2;
    const double first = curve_.curvature_per_m + curve_.sharpness_per_m2 * span.from;
    const double last = curve_.curvature_per_m + curve_.sharpness_per_m2 * span.to;
    const double k = std::max(std::abs(first), std::abs(last));
    return half * (std::abs(curve_.sharpness_per_m2) + k * k) * (distance + half);
  }

  void within(Span span) {
    const double middle = span.from + (span.to - span.from) / 2;
    const double half = (span.to - span.from) / 2;
    const Gap gap = visit(middle);
    const double least_bend = gap.bend - bend_margin(span, gap.distance_m);
    const double least =
        gap.half_square - std::abs(gap.slope) * half + std::min(0.0, least_bend) * half * half / 2;
    const double rounding = 2e-15 * (gap.half_square + best_.half_square);
    if (least >= best_.half_square - rounding) return;
    if (least_bend > 0) return descend(span, middle, gap);
    if (half <= 1e-13 * (1 + curve_.length_m)) return;
    const Span before{span.from, middle};
    const Span after{middle, span.to};
    within(gap.slope > 0 ? before : after);
    within(gap.slope > 0 ? after : before);
  }

  /// The only minimum of a span over which the distance is convex: Newton, halving where that leads out.
  void descend(Span span, double s, Gap gap) {
    for (int i = 0; i < 100; ++i) {
      (gap.slope > 0 ? span.to : span.from) = s;
      double next = s - gap.slope / gap.bend;
      if (next <= span.from || next >= span.to) next = tried_end(span, next);
      if (std::abs(next - s) <= 4e-16 * (std::abs(s) + gap.distance_m)) return;
      s = next;
      gap = visit(s);
    }
  }

  /// The end of the curve, where the minimum may be, or the middle.
  [[nodiscard]] double tried_end(Span span, double wanted) const {
    if (wanted <= span.from && span.from == 0) return span.from;
    if (wanted >= span.to && span.to == curve_.length_m) return span.to;
    return (span.from + span.to) / 2;
  }

  const Curve& curve_;
  Point place_;
  Best best_;
  bool found_ = false;
};

Nearest described(const Curve& curve, double station, Point place) {
  const CurveState state = state_at(curve, station);
  const Point way = place - state.at;
  const double side = cross(unit(state.heading_rad), way) < 0 ? -1 : 1;
  return {station, side * length_m(way), state.at};
}

}  // namespace

Nearest nearest_on(const Curve& curve, Point place) {
  Search search{curve, place, std::numeric_limits<double>::infinity()};
  return described(curve, search.run().value_or(0), place);
}

std::optional<Nearest> nearest_on(const Path& path, Point place) {
  std::optional<Nearest> nearest;
  double within = std::numeric_limits<double>::infinity();
  double begun = 0;
  for (const Stretch& stretch : path) {
    const Curve& curve = stretch.curve;
    const double closest = std::max(0.0, distance_m(curve.start, place) - curve.length_m);
    if (closest * closest / 2 < within) {
      Search search{curve, place, within};
      if (const auto station = search.run()) {
        nearest = described(curve, *station, place);
        nearest->station_m += begun;
        within = search.half_square();
      }
    }
    begun += curve.length_m;
  }
  return nearest;
}

}  // namespace selion
