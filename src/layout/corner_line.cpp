// SPDX-License-Identifier: GPL-3.0-or-later
#include "corner_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "selion/core/angle.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

constexpr double kFollow_m = 0.02;  // how far the corner line may stray from the ring
constexpr double kShortestEdge_m = 0.02;
constexpr double kSharpest_rad = 2.6;  // a corner of the line turning more than this is cut off
constexpr double kGentleCut_m =
    0.05;  // a corner may be driven at working speed if that cuts no more than this

}  // namespace

CornerLine::CornerLine(const Ground& ground, const Ring& ring) : ground_{ground} {
  const double most = 1 / ground.machine.min_work_radius_m.value_or(1e-9);
  tight_ = limits_at(ground.machine, ground.machine.turn_speed_mps);
  gentle_ = limits_at(ground.machine, ground.machine.work_speed_mps);
  tight_.curvature_per_m = std::min(tight_.curvature_per_m, most);
  gentle_.curvature_per_m = std::min(gentle_.curvature_per_m, most);
  for (const Point p : simplified(ring, kFollow_m)) vertices_.push_back({p, false, 0, 0, tight_});
}

void CornerLine::measure(std::size_t i) {
  Vertex& v = vertices_[i];
  v.turn_rad = wrapped(heading_rad(edge(i)) - heading_rad(edge(previous(i))));
  v.limits = tight_;
  v.tangent_m = std::abs(v.turn_rad) > kSharpest_rad ? std::numeric_limits<double>::infinity()
                                                     : corner_of(v.turn_rad, tight_).tangent_m;
}

void CornerLine::measure_all() {
  for (std::size_t i = 0; i < vertices_.size(); ++i) measure(i);
}

/// Puts the two ends of edge i into one corner, where the edges beside it meet. Only where both turn the same
/// way.
bool CornerLine::merge(std::size_t i) {
  if (vertices_.size() < 4) return false;
  const std::size_t j = next(i);
  const double sum = vertices_[i].turn_rad + vertices_[j].turn_rad;
  if (vertices_[i].turn_rad * vertices_[j].turn_rad <= 0 || std::abs(sum) > kSharpest_rad) return false;
  const Point before = edge(previous(i));
  const Point after = edge(j);
  const double across = cross(before, after);
  if (std::abs(across) < 1e-9 * length_m(before) * length_m(after)) return false;
  const double ahead = cross(vertices_[j].at - vertices_[i].at, after) / across;
  if (ahead < 0 || ahead * length_m(before) > 4 * length_m(edge(i)) + 1) return false;
  vertices_[i].at = vertices_[i].at + ahead * before;
  drop(j);
  return true;
}

/// Edge i is too short for the corners at its ends. A left turn may be left out, for that leads inwards.
void CornerLine::relieve(std::size_t i) {
  const std::size_t j = next(i);
  const bool i_too_sharp = std::isinf(vertices_[i].tangent_m);
  if (!i_too_sharp && std::isinf(vertices_[j].tangent_m)) return drop(j);
  if (i_too_sharp || length_m(edge(i)) < kShortestEdge_m) return drop(i);
  if (merge(i)) return;
  const bool i_left = vertices_[i].turn_rad > 0;
  const bool j_left = vertices_[j].turn_rad > 0;
  if (i_left != j_left) return drop(i_left ? i : j);
  drop(std::abs(vertices_[i].turn_rad) < std::abs(vertices_[j].turn_rad) ? i : j);
}

/// The edge that lacks the most room, if any does.
std::optional<std::size_t> CornerLine::tightest_edge() const {
  std::optional<std::size_t> tightest;
  double least_m = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const double room = length_m(edge(i)) < kShortestEdge_m ? -std::numeric_limits<double>::max() : room_m(i);
    if (room >= least_m) continue;
    least_m = room;
    tightest = i;
  }
  return tightest;
}

bool CornerLine::make_room() {
  measure_all();
  while (vertices_.size() >= 3) {
    const auto tightest = tightest_edge();
    if (!tightest) return true;
    relieve(*tightest);
    measure_all();
  }
  return false;
}

void CornerLine::make_gentle() {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    Vertex& v = vertices_[i];
    const Corner corner = corner_of(v.turn_rad, gentle_);
    const double more_m = corner.tangent_m - v.tangent_m;
    if (corner.cut_m > (v.turn_rad > 0 ? kGentleCut_m : kFollow_m / 4)) continue;
    if (room_m(i) < more_m || room_m(previous(i)) < more_m) continue;
    v.tangent_m = corner.tangent_m;
    v.limits = gentle_;
  }
}

Path CornerLine::corner_path(std::size_t i) const {
  const Vertex& v = vertices_[i];
  const double heading = heading_rad(edge(previous(i)));
  return swing({v.at - v.tangent_m * unit(heading), heading}, v.turn_rad, v.limits);
}

Path CornerLine::edge_path(std::size_t i) const {
  constexpr double kNoLine_m = 1e-7;  // below what joints of pieces are held to
  if (room_m(i) < kNoLine_m) return {};
  const Point along = unit(heading_rad(edge(i)));
  const Point a = vertices_[i].at + vertices_[i].tangent_m * along;
  return {{line(a, vertices_[next(i)].at - vertices_[next(i)].tangent_m * along), Gear::forward}};
}

Path CornerLine::path() const {
  Path path;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    append(path, edge_path(i));
    append(path, corner_path(next(i)));
  }
  return path;
}

}  // namespace selion
