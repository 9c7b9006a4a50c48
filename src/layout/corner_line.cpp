// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr double kGentleCut_m =
    0.05;  // a corner may be driven at working speed if that cuts no more than this

}  // namespace

CornerLine::CornerLine(const Ground& ground, const Ring& line, double room_m) : ground_{ground} {
  const double most = 1 / ground.machine.min_work_radius_m.value_or(1e-9);
  tight_ = limits_at(ground.machine, ground.machine.turn_speed_mps);
  gentle_ = limits_at(ground.machine, ground.machine.work_speed_mps);
  tight_.curvature_per_m = std::min(tight_.curvature_per_m, most);
  gentle_.curvature_per_m = std::min(gentle_.curvature_per_m, most);
  count_ = line.size();
  for (Index i = 0; i < count_; ++i) {
    Vertex v;
    v.at = line[i];
    v.previous = (i + count_ - 1) % count_;
    v.next = (i + 1) % count_;
    v.room_m = room_m;
    vertices_.push_back(v);
  }
  measure_all();
}

double CornerLine::room_m(Index i) const {
  const double length = length_m(edge(i));
  if (length < kLeastEdge_m) return -std::numeric_limits<double>::max();
  return length - vertices_[i].reach.after_m - vertices_[next(i)].reach.before_m;
}

CornerShape CornerLine::tight_shape(double turn_rad, double room_m) const {
  return shape_within(turn_rad, tight_, ground_.footprint, room_m);
}

/// Kept where nothing has changed but rounding.
void CornerLine::make_shape(Vertex& v) const {
  constexpr double kSame = 1e-9;  // rad, m
  if (std::abs(v.turn_rad - v.shaped_for_rad) < kSame && std::abs(v.room_m - v.shaped_in_m) < kSame) return;
  v.shaped_for_rad = v.turn_rad;
  v.shaped_in_m = v.room_m;
  v.shape = std::abs(v.turn_rad) > kSharpest_rad ? CornerShape{tight_} : tight_shape(v.turn_rad, v.room_m);
}

void CornerLine::measure(Index i) {
  constexpr double kNoRoom = std::numeric_limits<double>::infinity();
  Vertex& v = vertices_[i];
  if (v.gentle) v.shaped_in_m = -1;
  v.gentle = v.corner_stays = v.edge_stays = vertices_[v.previous].edge_stays = false;
  v.turn_rad = wrapped(heading_rad(edge(i)) - heading_rad(edge(v.previous)));
  const bool too_sharp = std::abs(v.turn_rad) > kSharpest_rad;
  make_shape(v);
  v.reach = too_sharp ? CornerReach{kNoRoom, kNoRoom, 0} : reach_of(v.turn_rad, v.shape);
}

/// The corner, its neighbours and the edges between them.
void CornerLine::measure_around(Index i) {
  const auto indices = {previous(i), i, next(i)};
  for (const Index k : indices) measure(k);
  for (const Index k : {previous(previous(i)), previous(i), i, next(i)})
    if (const double room = room_m(k); room < 0) tight_edges_.push({room, k});
}

void CornerLine::measure_all() {
  Index i = first_;
  for (std::size_t k = 0; k < count_; ++k, i = next(i)) measure(i);
  for (std::size_t k = 0; k < count_; ++k, i = next(i))
    if (const double room = room_m(i); room < 0) tight_edges_.push({room, i});
}

void CornerLine::drop(Index i) {
  Vertex& v = vertices_[i];
  v.dropped = true;
  vertices_[v.previous].next = v.next;
  vertices_[v.next].previous = v.previous;
  if (first_ == i) first_ = v.next;
  --count_;
  if (count_ >= 3) measure_around(v.next);
}

/// Puts others in the place of a corner.
void CornerLine::replace(Index i, const std::vector<Vertex>& by) {
  Index last = previous(i);
  const Index after = next(i);
  if (first_ == i) first_ = after;
  vertices_[i].dropped = true;
  for (Vertex v : by) {
    v.previous = last;
    vertices_[last].next = vertices_.size();
    last = vertices_.size();
    vertices_.push_back(v);
  }
  vertices_[last].next = after;
  vertices_[after].previous = last;
  count_ += by.size() - 1;
  for (Index k = vertices_.size() - by.size(); k < vertices_.size(); ++k) measure_around(k);
}

void CornerLine::make_gentle() {
  Index i = first_;
  for (std::size_t k = 0; k < count_; ++k, i = next(i)) {
    Vertex& v = vertices_[i];
    if (v.gentle || !v.may_gentle || v.shape.ease_in_m > 0 || v.shape.ease_out_m > 0) continue;
    const CornerShape shape{gentle_};
    const CornerReach reach = reach_of(v.turn_rad, shape);
    if (reach.cut_m > (v.turn_rad > 0 ? kGentleCut_m : kFollow_m / 4)) continue;
    if (room_m(i) < reach.after_m - v.reach.after_m) continue;
    if (room_m(v.previous) < reach.before_m - v.reach.before_m) continue;
    v.gentle = true;
    v.corner_stays = v.edge_stays = vertices_[v.previous].edge_stays = false;
    v.shape = shape;
    v.reach = reach;
  }
}

Path CornerLine::corner_at(Index i) const {
  const Vertex& v = vertices_[i];
  const double heading = heading_rad(edge(v.previous));
  return corner_path({v.at - v.reach.before_m * unit(heading), heading}, v.turn_rad, v.shape);
}

Path CornerLine::edge_path(Index i) const {
  constexpr double kNoLine_m = 1e-7;  // below what joints of pieces are held to
  if (room_m(i) < kNoLine_m) return {};
  const Point along = unit(heading_rad(edge(i)));
  const Point a = vertices_[i].at + vertices_[i].reach.after_m * along;
  return {{line(a, vertices_[next(i)].at - vertices_[next(i)].reach.before_m * along), Gear::forward}};
}

Path CornerLine::path() const {
  Path path;
  Index i = first_;
  for (std::size_t k = 0; k < count_; ++k, i = next(i)) {
    append(path, edge_path(i));
    append(path, corner_at(next(i)));
  }
  return path;
}

}  // namespace selion
