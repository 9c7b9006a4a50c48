// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "corner_line.hpp"

namespace selion {
namespace {

constexpr double kPush_m = 0.15;  // how far a corner that does not fit moves at a time
constexpr double kNoRoom_m = 0.01;

}  // namespace

bool CornerLine::stays(const Path& path) const {
  return stays_inside(ground_.space, ground_.footprint, path);
}

bool CornerLine::check_corner(Index i) {
  Vertex& v = vertices_[i];
  if (!v.corner_stays) v.corner_stays = stays(corner_at(i));
  return v.corner_stays;
}

bool CornerLine::check_edge(Index i) {
  Vertex& v = vertices_[i];
  if (!v.edge_stays) v.edge_stays = stays(edge_path(i));
  return v.edge_stays;
}

/// Takes back what made a corner wider than it need be; false where it was tight already.
bool CornerLine::ease(Index i) {
  Vertex& v = vertices_[i];
  const bool was_gentle = v.gentle;
  v.may_gentle = v.gentle = false;
  const bool less_room = v.turn_rad > 0 && v.room_m > kNoRoom_m;
  if (less_room) v.room_m = kNoRoom_m;
  measure_around(i);
  return was_gentle || (less_room && (v.shape.ease_in_m > 0 || v.shape.ease_out_m > 0));
}

/// How far from a left turn the two corners have to lie that it is cut into.
double CornerLine::chamfer_wish_m(Index i) const {
  const Vertex& v = vertices_[i];
  const double half = v.turn_rad / 2;
  const CornerReach reach = reach_of(half, tight_shape(half, v.room_m));
  return std::max(kPush_m, 1.02 * (reach.before_m + reach.after_m) / (2 * std::cos(half)));
}

/// Cuts a left turn off, with room for the two corners that come of it; leaves it out where that was tried.
void CornerLine::chamfer(Index i) {
  const Vertex v = vertices_[i];
  const double wish = chamfer_wish_m(i);
  const double before = std::min(wish, length_m(edge(v.previous)) / 2);
  const double after = std::min(wish, length_m(edge(i)) / 2);
  if (v.cut && std::min(before, after) < wish) return drop(i);
  Vertex first = v;
  first.cut = true;
  Vertex second = first;
  first.at = v.at - before * unit(heading_rad(edge(v.previous)));
  second.at = v.at + after * unit(heading_rad(edge(i)));
  replace(i, {first, second});
}

/// A right turn driven round more widely: left by `by_rad` away from the line, right by so much more, and
/// left again onto the line; as close to each other as the three turns can be.
std::vector<CornerLine::Vertex> CornerLine::wide(Index i, double by_rad) const {
  constexpr double kBetween_m = 0.02;
  const Vertex& v = vertices_[i];
  const double turn = -v.turn_rad;
  const double in = heading_rad(edge(v.previous));
  std::array<Vertex, 3> by{v, v, v};
  by[0].turn_rad = by[2].turn_rad = by_rad;
  by[1].turn_rad = -(turn + 2 * by_rad);
  for (Vertex& part : by) {
    part.pushed = true;
    part.may_gentle = part.gentle = false;
  }
  for (const Index k : {Index{0}, Index{1}}) {
    make_shape(by[k]);
    by[k].reach = reach_of(by[k].turn_rad, by[k].shape);
  }
  by[2].shape = by[0].shape;
  by[2].shaped_for_rad = by[0].shaped_for_rad;
  by[2].shaped_in_m = by[0].shaped_in_m;
  by[2].reach = by[0].reach;
  const double out_m = by[0].reach.after_m + by[1].reach.before_m + kBetween_m;
  const double back_m = by[1].reach.after_m + by[2].reach.before_m + kBetween_m;
  const double begin_m = (out_m * std::sin(turn + by_rad) - back_m * std::sin(by_rad)) / std::sin(turn);
  by[0].at = v.at - begin_m * unit(in);
  by[1].at = by[0].at + out_m * unit(in + by_rad);
  by[2].at = by[1].at + back_m * unit(in - turn - by_rad);
  return {by.begin(), by.end()};
}

bool CornerLine::fits_wide(Index i, const std::vector<Vertex>& wide) const {
  const Vertex& v = vertices_[i];
  const Point in = edge(v.previous);
  const Point out = edge(i);
  const double begin_m = dot(v.at - wide.front().at, in) / length_m(in);
  const double end_m = dot(wide.back().at - v.at, out) / length_m(out);
  const double before = length_m(in) - vertices_[v.previous].reach.after_m;
  const double after = length_m(out) - vertices_[v.next].reach.before_m;
  if (begin_m + wide.front().reach.before_m > before || end_m + wide.back().reach.after_m > after)
    return false;
  const double heading = heading_rad(in);
  Path path = corner_path({wide[0].at - wide[0].reach.before_m * unit(heading), heading}, wide[0].turn_rad,
                          wide[0].shape);
  for (std::size_t k = 1; k < wide.size(); ++k) {
    const Pose last = end_pose(path);
    const Point begin = wide[k].at - wide[k].reach.before_m * unit(last.heading_rad);
    path.push_back({line(last.at, begin), Gear::forward});
    append(path, corner_path({begin, last.heading_rad}, wide[k].turn_rad, wide[k].shape));
  }
  return stays(path);
}

/// The least wide way round a right turn that stays inside; false where there is none.
bool CornerLine::swing_wide(Index i) {
  constexpr auto kTries_rad = std::to_array({0.08, 0.16, 0.25, 0.35, 0.5, 0.65, 0.8, 1.0});
  constexpr int kHalvings = 4;
  constexpr double kWidest_rad = 2.6;
  const Vertex& v = vertices_[i];
  if (v.pushed || -v.turn_rad < 0.02) return false;
  double low = 0;
  for (const double wish : kTries_rad) {
    if (-v.turn_rad + 2 * wish > kWidest_rad) return false;
    std::vector<Vertex> best = wide(i, wish);
    if (!fits_wide(i, best)) {
      low = wish;
      continue;
    }
    double high = wish;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      std::vector<Vertex> less = wide(i, middle);
      if (fits_wide(i, less)) {
        best = std::move(less);
        high = middle;
      } else {
        low = middle;
      }
    }
    replace(i, best);
    return true;
  }
  return false;
}

/// Moves a right turn away from the border; the edges are left only near it.
void CornerLine::swing_out(Index i) {
  const Vertex v = vertices_[i];
  const Point in = unit(heading_rad(edge(v.previous)));
  const Point out = unit(heading_rad(edge(i)));
  const Point away = left_of(in) + left_of(out);
  const double span = 4 * corner_of(v.turn_rad, tight_).tangent_m + ground_.half_m;
  std::vector<Vertex> by;
  const auto add = [&](Point at, bool pushed) {
    Vertex part = v;
    part.at = at;
    part.pushed = pushed;
    by.push_back(part);
  };
  if (!v.pushed) add(v.at - std::min(span, length_m(edge(v.previous)) / 2) * in, false);
  add(v.at + (kPush_m / std::max(length_m(away), 0.1)) * away, true);
  if (!v.pushed) add(v.at + std::min(span, length_m(edge(i)) / 2) * out, false);
  replace(i, by);
}

bool CornerLine::repair() {
  std::vector<Index> failing;
  Index i = first_;
  for (std::size_t k = 0; k < count_; ++k, i = next(i)) {
    const bool stays = check_corner(i) && check_edge(i) && check_edge(previous(i));
    if (!stays && std::abs(vertices_[i].turn_rad) >= 1e-6) failing.push_back(i);
  }
  for (const Index k : failing) {
    if (vertices_[k].dropped || ease(k)) continue;
    if (vertices_[k].turn_rad > 0)
      chamfer(k);
    else if (!swing_wide(k))
      swing_out(k);
  }
  return !failing.empty();
}

}  // namespace selion
