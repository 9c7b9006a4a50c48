// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "beside.hpp"
#include "selion/motion/nearest.hpp"

namespace selion {
namespace {

// Curves this close meet, and those that stay within kTogether side by side are not told apart further;
// pieces shorter than kShortest that are still parallel are looked at as a whole.
constexpr double kTouching_m = 1e-9;
constexpr double kTogether_m = 2e-9;
constexpr double kShortest_m = 1e-4;

struct Place {
  double s = 0;
  CurveState state;
};

Place place_on(const Curve& curve, double s) { return {s, state_at(curve, s)}; }

/// A piece of a curve and how far it may lie from its chord.
struct Piece {
  Place from;
  Place to;
  double width = 0;
  double turn = 0;  ///< no two of its tangents differ by more

  [[nodiscard]] double length() const { return to.s - from.s; }
};

Piece piece_between(const Place& from, const Place& to) {
  const double k = std::max(std::abs(from.state.curvature_per_m), std::abs(to.state.curvature_per_m));
  const double length = to.s - from.s;
  return {from, to, k * length * length / 8, k * length};
}

double distance_to_segment(Point p, Point a, Point b) {
  const Point way = b - a;
  const double square = dot(way, way);
  const double share = square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
  return distance_m(p, a + share * way);
}

double chord_distance(const Piece& p, const Piece& q) {
  const auto [a, b] = std::pair{p.from.state.at, p.to.state.at};
  const auto [c, d] = std::pair{q.from.state.at, q.to.state.at};
  const bool is_split = cross(b - a, c - a) * cross(b - a, d - a) < 0;
  if (is_split && cross(d - c, a - c) * cross(d - c, b - c) < 0) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

bool may_meet(const Piece& p, const Piece& q) {
  return chord_distance(p, q) <= p.width + q.width + kTouching_m;
}

/// No tangent of the one is parallel to any of the other, so that they cross once at most.
bool is_transversal(const Piece& p, const Piece& q) {
  constexpr double kMostTurn = 1;
  if (p.turn + q.turn > kMostTurn) return false;
  const double between = std::asin(
      std::min(1.0, std::abs(cross(unit(p.from.state.heading_rad), unit(q.from.state.heading_rad)))));
  return between > p.turn + q.turn + 1e-6;
}

/// Do the curves go on as one from there, in one sense or the other? Same place, tangent, curvature and
/// sharpness.
bool is_shared(const Curve& first, const Curve& second, const Crossing& there) {
  const CurveState a = state_at(first, there.first_m);
  const CurveState b = state_at(second, there.second_m);
  const double sense = dot(unit(a.heading_rad), unit(b.heading_rad)) < 0 ? -1 : 1;
  return distance_m(a.at, b.at) <= kTouching_m &&
         std::abs(cross(unit(a.heading_rad), unit(b.heading_rad))) <= kTouching_m &&
         std::abs(a.curvature_per_m - sense * b.curvature_per_m) <= kTouching_m &&
         std::abs(first.sharpness_per_m2 - second.sharpness_per_m2) <= kTouching_m;
}

/// The ends of what one curve shares with the other if they are parts of the same, else fewer than two.
std::vector<Crossing> shared_ends(const Curve& first, const Curve& second) {
  std::vector<Crossing> ends;
  const auto add = [&](double s, double t) {
    Crossing end{s, t, state_at(first, s).at, Meeting::overlap};
    const auto is_same = [&](const Crossing& other) {
      return std::abs(other.first_m - s) <= 10 * kShortest_m;
    };
    if (is_shared(first, second, end) && std::none_of(ends.begin(), ends.end(), is_same)) ends.push_back(end);
  };
  if (std::abs(first.sharpness_per_m2 - second.sharpness_per_m2) > kTouching_m) return ends;
  for (const double s : {0.0, first.length_m}) add(s, nearest_on(second, state_at(first, s).at).station_m);
  for (const double t : {0.0, second.length_m}) add(nearest_on(first, state_at(second, t).at).station_m, t);
  std::sort(ends.begin(), ends.end(),
            [](const Crossing& a, const Crossing& b) { return a.first_m < b.first_m; });
  return ends;
}

struct Pair {
  double first = 0;
  double second = 0;
};

/// Side by side from the one to the other, which may be the same.
struct Run {
  Crossing from;
  Crossing to;
};

class Search {
 public:
  Search(const Curve& first, const Curve& second) : first_{first}, second_{second} {}

  std::vector<Crossing> run() {
    auto shared = shared_ends(first_, second_);
    if (shared.size() == 2) return shared;
    compare(whole(first_), whole(second_));
    std::sort(found_.begin(), found_.end(), [](const Run& a, const Run& b) {
      return std::pair{a.from.first_m, a.from.second_m} < std::pair{b.from.first_m, b.from.second_m};
    });
    return merged();
  }

 private:
  static Piece whole(const Curve& curve) {
    return piece_between(place_on(curve, 0), place_on(curve, curve.length_m));
  }

  void compare(const Piece& p, const Piece& q) {
    if (!may_meet(p, q)) return;
    const bool is_short = p.length() <= kShortest_m && q.length() <= kShortest_m;
    if (is_transversal(p, q)) {
      if (add_crossing(p, q) || is_short) return;
    } else if (is_short) {
      return add_touching(p, q);
    } else if (is_settled(p, q)) {
      return;
    }
    if (p.length() >= q.length()) {
      const Place middle = place_on(first_, (p.from.s + p.to.s) / 2);
      compare(piece_between(p.from, middle), q);
      compare(piece_between(middle, p.to), q);
    } else {
      const Place middle = place_on(second_, (q.from.s + q.to.s) / 2);
      compare(p, piece_between(q.from, middle));
      compare(p, piece_between(middle, q.to));
    }
  }

  /// Are the pieces apart all along, or side by side all along? Else nothing would tell near curves apart but
  /// pieces as short as they are near.
  bool is_settled(const Piece& p, const Piece& q) {
    constexpr double kMostTurn = 0.1;
    if (p.turn + q.turn > kMostTurn || p.length() > 2 * q.length() || q.length() > 2 * p.length())
      return false;
    const auto found = beside(first_, {p.from.s, p.to.s}, second_, {q.from.s, q.to.s});
    if (!found) return false;
    if (found->least_m > kTouching_m) return true;
    if (found->most_m > kTogether_m) return false;
    found_.push_back({meeting_at({p.from.s, found->feet.from_m}, Meeting::touching),
                      meeting_at({p.to.s, found->feet.to_m}, Meeting::touching)});
    return true;
  }

  /// Is the crossing within both pieces? Then it is the only one.
  bool add_crossing(const Piece& p, const Piece& q) {
    Pair at{(p.from.s + p.to.s) / 2, (q.from.s + q.to.s) / 2};
    const double reach = p.length() + q.length();
    for (int i = 0; i < 12; ++i) {
      const CurveState a = state_at(first_, at.first);
      const CurveState b = state_at(second_, at.second);
      const Point apart = b.at - a.at;
      const Point along = unit(a.heading_rad);
      const Point other = unit(b.heading_rad);
      const double size = cross(along, other);
      const Pair step{cross(apart, other) / size, cross(apart, along) / size};
      at = {at.first + step.first, at.second + step.second};
      if (!(std::abs(step.first) + std::abs(step.second) < 4 * reach)) return false;
      if (std::abs(step.first) + std::abs(step.second) > 1e-12) continue;
      return add_within(p, q, at);
    }
    return false;
  }

  bool add_within(const Piece& p, const Piece& q, const Pair& at) {
    const Pair kept{std::clamp(at.first, p.from.s, p.to.s), std::clamp(at.second, q.from.s, q.to.s)};
    if (std::abs(kept.first - at.first) + std::abs(kept.second - at.second) > kTouching_m) return false;
    add(kept, Meeting::crossing);
    return true;
  }

  /// Where the tangents are parallel and the way between is square to them, else the middle.
  void add_touching(const Piece& p, const Piece& q) {
    Pair at{(p.from.s + p.to.s) / 2, (q.from.s + q.to.s) / 2};
    const Pair middle = at;
    for (int i = 0; i < 8; ++i) {
      const CurveState a = state_at(first_, at.first);
      const CurveState b = state_at(second_, at.second);
      const Point along = unit(a.heading_rad);
      const Point other = unit(b.heading_rad);
      const double cosine = dot(along, other);
      const double apart = dot(b.at - a.at, along);
      const double angle = cross(along, other);
      const double size = cosine * b.curvature_per_m - a.curvature_per_m;
      if (std::abs(size) < 1e-6) break;
      // along . (P2 - P1) and the sine of the headings' difference, both linear in the steps.
      const double second = (apart * a.curvature_per_m - angle / cosine) / size;
      const double first = apart + cosine * second;
      at = {at.first + first, at.second + second};
      if (!(std::abs(at.first - middle.first) + std::abs(at.second - middle.second) < 3 * kShortest_m)) break;
      if (std::abs(first) + std::abs(second) < 1e-13) return add_close(p, q, at);
    }
    add_close(p, q, middle);
  }

  void add_close(const Piece& p, const Piece& q, Pair at) {
    at = {std::clamp(at.first, p.from.s, p.to.s), std::clamp(at.second, q.from.s, q.to.s)};
    // From foot to foot, so that pieces that share an end only are seen to.
    for (int i = 0; i < 3; ++i) {
      const CurveState b = state_at(second_, at.second);
      const double forwards = dot(state_at(first_, at.first).at - b.at, unit(b.heading_rad));
      at.second = std::clamp(at.second + forwards, q.from.s, q.to.s);
      const CurveState a = state_at(first_, at.first);
      const double back = dot(state_at(second_, at.second).at - a.at, unit(a.heading_rad));
      at.first = std::clamp(at.first + back, p.from.s, p.to.s);
    }
    if (distance_m(state_at(first_, at.first).at, state_at(second_, at.second).at) <= kTouching_m)
      add(at, Meeting::touching);
  }

  [[nodiscard]] Crossing meeting_at(const Pair& at, Meeting meeting) const {
    return {at.first, at.second, state_at(first_, at.first).at, meeting};
  }

  void add(const Pair& at, Meeting meeting) {
    const Crossing there = meeting_at(at, meeting);
    found_.push_back({there, there});
  }

  /// Does `b` go on with the run of touching pieces, or is it the same meeting?
  static bool is_next(const Run& run, const Run& b) {
    const bool is_crossing = run.to.meeting == Meeting::crossing && b.from.meeting == Meeting::crossing;
    const double near = is_crossing ? 4 * kTouching_m : 3 * kShortest_m;
    const double ahead = b.from.first_m - run.to.first_m;
    // Within the run, the second curve is where the run has it.
    const double sense = run.to.second_m < run.from.second_m ? -1 : 1;
    const double second = run.to.second_m + (ahead < 0 ? sense * ahead : 0);
    return ahead <= near && std::abs(b.from.second_m - second) <= near;
  }

  static Run joined(Run run, const Run& next) {
    if (next.to.first_m >= run.to.first_m) run.to = next.to;
    if (next.to.meeting == Meeting::crossing) run.from.meeting = Meeting::crossing;
    return run;
  }

  [[nodiscard]] std::vector<Crossing> merged() const {
    std::vector<Crossing> all;
    std::vector<bool> is_used(found_.size());
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (is_used[i]) continue;
      Run run = found_[i];
      for (std::size_t j = i + 1;
           j < found_.size() && found_[j].from.first_m - run.to.first_m <= 3 * kShortest_m; ++j) {
        if (is_used[j] || !is_next(run, found_[j])) continue;
        is_used[j] = true;
        run = joined(run, found_[j]);
      }
      append_run(all, run.from, run.to);
    }
    return all;
  }

  static void append_run(std::vector<Crossing>& all, Crossing begin, Crossing end) {
    if (end.first_m - begin.first_m > 10 * kShortest_m) {
      begin.meeting = end.meeting = Meeting::overlap;
      all.push_back(begin);
      all.push_back(end);
    } else {
      all.push_back(begin.meeting == Meeting::crossing && end.meeting == Meeting::crossing ? end : begin);
    }
  }

  const Curve& first_;
  const Curve& second_;
  std::vector<Run> found_;
};

}  // namespace

std::vector<Crossing> crossings(const Curve& first, const Curve& second) {
  return Search{first, second}.run();
}

}  // namespace selion
