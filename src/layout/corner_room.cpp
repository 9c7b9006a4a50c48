// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of a ring too short for the corners at their ends: what is merged, moved or left out.
#include <algorithm>
#include <cmath>

#include "corner_line.hpp"

namespace selion {
namespace {

constexpr double kSpread_m = 0.02;
constexpr double kOneSide = 0.6;  // of the room that lacks: more than half, for the turns become sharper

}  // namespace

/// Puts the two ends of edge i into one corner, where the edges beside it meet. Only where both turn the same
/// way.
bool CornerLine::merge(Index i) {
  if (count_ < 4) return false;
  const Index j = next(i);
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
  measure_around(i);
  return true;
}

/// Moves the left turn at one end of edge i back along the edge beyond it, until the edge is long enough:
/// that cuts the corner, and leaves the line of the other edge, which may be a long one, as it is. False
/// where there is no such place.
bool CornerLine::slide(Index i, Index corner) {
  constexpr int kHalvings = 8;
  const bool back = corner == i;
  const Index beyond = back ? previous(i) : corner;  // the edge that it slides along
  const Vertex before = vertices_[corner];
  const Point away = back ? -1 * edge(beyond) : edge(beyond);
  const auto fits_at = [&](double share) {
    vertices_[corner].at = before.at + share * away;
    for (const Index k : {i, next(i)}) measure(k);
    return room_m(i) >= 0 && room_m(beyond) >= 0;
  };
  double low = 0;
  double high = 0.5;
  bool found = false;
  for (double share = 1.0 / 64; share <= 0.5 && !found; share *= 2) {
    found = fits_at(share);
    (found ? high : low) = share;
  }
  for (int k = 0; found && k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    (fits_at(middle) ? high : low) = middle;
  }
  vertices_[corner].at = found ? before.at + high * away : before.at;
  measure_around(corner);
  return found;
}

/// A tip too sharp to be driven round is cut off, across both its edges or where one of them, the longer one
/// first, leaves room; without it the line would lead askew from one end of a long edge to the other.
void CornerLine::blunt(Index i) {
  if (vertices_[i].turn_rad > 0) {
    if (chamfer_wish_m(i) <= std::min(length_m(edge(previous(i))), length_m(edge(i))) / 2) return chamfer(i);
    const bool after_is_longer = length_m(edge(i)) > length_m(edge(previous(i)));
    if (slide(after_is_longer ? previous(i) : i, i) || slide(after_is_longer ? i : previous(i), i)) return;
  }
  drop(i);
}

/// Leads round a tip with a bulb where the edge i at its end is too short for the right turns there: out from
/// the line before it, back onto the line after it. Without it the line would lead askew from the far end of
/// one of the tip's sides.
bool CornerLine::spread(Index i) {
  const Index j = next(i);
  const Vertex first = vertices_[i];
  const Vertex last = vertices_[j];
  if (count_ < 4 || first.turn_rad >= 0 || last.turn_rad >= 0) return false;
  if (-(first.turn_rad + last.turn_rad) <= kSharpest_rad) return false;
  const Point in = unit(heading_rad(edge(previous(i))));
  const Point along = unit(heading_rad(edge(i)));
  const Point out = unit(heading_rad(edge(j)));
  const double by_m = kSpread_m - kOneSide * room_m(i);
  const double span_m = 4 * corner_of(first.turn_rad, tight_).tangent_m + ground_.half_m;
  const double before_m = std::min(span_m, length_m(edge(previous(i))) / 2);
  const double after_m = std::min(span_m, length_m(edge(j)) / 2);
  const auto moved = [](Vertex v, Point at, bool pushed) {
    v.at = at;
    v.pushed = pushed;
    return v;
  };
  std::vector<Vertex> left{moved(first, first.at - by_m * along, true)};
  std::vector<Vertex> right{moved(last, last.at + by_m * along, true)};
  if (!first.pushed) left.insert(left.begin(), moved(first, first.at - before_m * in, false));
  if (!last.pushed) right.push_back(moved(last, last.at + after_m * out, false));
  replace(i, left);
  replace(j, right);
  return true;
}

/// Edge i is too short for the corners at its ends. A left turn may be cut or left out, for that leads
/// inwards.
void CornerLine::relieve(Index i) {
  const Index j = next(i);
  const bool i_too_sharp = std::isinf(vertices_[i].reach.after_m);
  if (!i_too_sharp && std::isinf(vertices_[j].reach.before_m)) return blunt(j);
  if (length_m(edge(i)) < kLeastEdge_m) return drop(i);
  if (i_too_sharp) return blunt(i);
  if (merge(i) || spread(i)) return;
  const bool i_left = vertices_[i].turn_rad > 0;
  const bool j_left = vertices_[j].turn_rad > 0;
  if (i_left && slide(i, i)) return;
  if (j_left && slide(i, j)) return;
  if (i_left != j_left) return drop(i_left ? i : j);
  drop(std::abs(vertices_[i].turn_rad) < std::abs(vertices_[j].turn_rad) ? i : j);
}

bool CornerLine::make_room() {
  while (count_ >= 3 && !tight_edges_.empty()) {
    const Tight tight = tight_edges_.top();
    tight_edges_.pop();
    if (!vertices_[tight.edge].dropped && room_m(tight.edge) == tight.room_m) relieve(tight.edge);
  }
  return count_ >= 3;
}

}  // namespace selion
