// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "corner_line.hpp"

namespace selion {
namespace {

constexpr double kPush_m = 0.15;  // how far a corner that does not fit moves at a time

}  // namespace

/// Cuts a left turn off, with room for the two corners that come of it.
void CornerLine::chamfer(std::size_t i, std::vector<Vertex>& into) const {
  const Vertex& v = vertices_[i];
  const double half = v.turn_rad / 2;
  const double wish = std::max(kPush_m, 1.02 * corner_of(half, tight_).tangent_m / std::cos(half));
  const double before = std::min(wish, length_m(edge(previous(i))) / 2);
  const double after = std::min(wish, length_m(edge(i)) / 2);
  into.push_back({v.at - before * unit(heading_rad(edge(previous(i)))), false, 0, 0, tight_});
  into.push_back({v.at + after * unit(heading_rad(edge(i))), false, 0, 0, tight_});
}

/// Moves a right turn away from the border; the edges are left only near it.
void CornerLine::swing_out(std::size_t i, std::vector<Vertex>& into) const {
  const Vertex& v = vertices_[i];
  const Point in = unit(heading_rad(edge(previous(i))));
  const Point out = unit(heading_rad(edge(i)));
  const Point away = left_of(in) + left_of(out);
  const double span = 4 * corner_of(v.turn_rad, tight_).tangent_m + ground_.half_m;
  const double before = std::min(span, length_m(edge(previous(i))) / 2);
  const double after = std::min(span, length_m(edge(i)) / 2);
  if (!v.pushed) into.push_back({v.at - before * in, false, 0, 0, tight_});
  into.push_back({v.at + (kPush_m / std::max(length_m(away), 0.1)) * away, true, 0, 0, tight_});
  if (!v.pushed) into.push_back({v.at + after * out, false, 0, 0, tight_});
}

bool CornerLine::repair() {
  std::vector<Vertex> repaired;
  bool moved = false;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const bool stays = stays_inside(ground_.space, ground_.footprint, corner_path(i)) &&
                       stays_inside(ground_.space, ground_.footprint, edge_path(i)) &&
                       stays_inside(ground_.space, ground_.footprint, edge_path(previous(i)));
    if (stays || std::abs(vertices_[i].turn_rad) < 1e-6) {
      repaired.push_back(vertices_[i]);
      continue;
    }
    moved = true;
    if (vertices_[i].turn_rad > 0)
      chamfer(i, repaired);
    else
      swing_out(i, repaired);
  }
  vertices_ = std::move(repaired);
  return moved;
}

}  // namespace selion
