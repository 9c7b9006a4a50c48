// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parts.hpp"

namespace selion {
namespace {

constexpr double kSliver_m = 0.1;         // gaps narrower than twice this are guidance error, not a pocket
constexpr double kPassWorth = 0.75;       // of a square of the working width: least area worth a pass
constexpr double kLeastLength = 1.5;      // of the working width
constexpr int kRounds = 2;

Polygons covered_by(const Ground& ground, const Layout& layout, const std::vector<Swath>& pockets) {
  Polygons swept;
  const auto take = [&](const Path& path) {
    for (Ring& piece : swept_by_tool(ground.footprint, path)) swept.push_back({std::move(piece), {}});
  };
  for (const HeadlandPass& pass : layout.headland_passes) take(pass.path);
  for (const Swath& swath : layout.swaths) take(swath_path(ground.machine, swath.from, swath.to));
  for (const Swath& swath : pockets) take(swath_path(ground.machine, swath.from, swath.to));
  return unite(swept);
}

/// The heading along which the part is narrowest across: one of its own edges' (Freeman and Shapira 1975).
double long_heading(const Polygon& part) {
  double best = 0;
  double least_m = std::numeric_limits<double>::infinity();
  const Ring& ring = part.shell;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (distance_m(ring[j], ring[i]) < kSliver_m) continue;
    const double heading = heading_rad(ring[i] - ring[j]);
    const Point side = left_of(unit(heading));
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point p : ring) low = std::min(low, dot(p, side)), high = std::max(high, dot(p, side));
    if (high - low < least_m - 1e-6) least_m = high - low, best = heading;
  }
  return best;
}

/// Straight strips over one part, spread evenly across it, each as long as what it finds there.
std::vector<Swath> pieces_over(const Ground& ground, const Polygon& part) {
  const double width = ground.machine.working_width_m;
  const Point along = unit(long_heading(part));
  const Point side = left_of(along);
  double low_a = std::numeric_limits<double>::infinity(), high_a = -low_a, low_c = low_a, high_c = -low_a;
  for (const Point p : part.shell) {
    low_a = std::min(low_a, dot(p, along)), high_a = std::max(high_a, dot(p, along));
    low_c = std::min(low_c, dot(p, side)), high_c = std::max(high_c, dot(p, side));
  }
  const int count = std::max(1, static_cast<int>(std::ceil((high_c - low_c - kSliver_m) / width)));
  std::vector<Swath> pieces;
  for (int k = 0; k < count; ++k) {
    const double c = count == 1 ? (low_c + high_c) / 2 : low_c + width / 2 + (high_c - low_c - width) * k / (count - 1);
    const Point a = low_a * along + c * side;
    const Point b = high_a * along + c * side;
    for (const Span1& span : drivable_spans(ground, a, b)) {
      const Swath piece{"", 0, a + span.from_m * along, a + span.to_m * along};
      double from = std::numeric_limits<double>::infinity();
      double to = -from;
      double gain_m2 = 0;
      if (span.to_m - span.from_m < kSliver_m) continue;
      for (const Polygon& gained : intersect({part}, {Polygon{strip(piece.from, piece.to, width), {}}})) {
        gain_m2 += area_m2(gained);
        for (const Point p : gained.shell) from = std::min(from, dot(p - a, along)), to = std::max(to, dot(p - a, along));
      }
      if (gain_m2 >= kPassWorth * width * width) pieces.push_back({"", 0, a + from * along, a + to * along});
    }
  }
  return pieces;
}

/// As much of the piece as the machine fits on, driven at least one way; absent where too little is left.
std::optional<Swath> fitted(const Ground& ground, const Swath& piece) {
  const double length = distance_m(piece.from, piece.to);
  const Point along = (1 / length) * (piece.to - piece.from);
  constexpr double kStep_m = 0.25;
  Swath best = piece;
  double longest = 0;
  for (const double sign : {1.0, -1.0}) {
    const double heading = heading_rad(sign * along);
    double from = -1;
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kStep_m)));
    for (int k = 0; k <= steps + 1; ++k) {
      const double s = length * std::min(k, steps) / steps;
      const Point tool = sign > 0 ? piece.from + s * along : piece.to - s * along;
      const Pose axle{tool + (-ground.machine.tool_x_m) * unit(heading), heading};
      const bool inside = k <= steps && fits(ground.space, ground.footprint, axle);
      if (inside && from < 0) from = s;
      if (inside || from < 0) continue;
      const double to = k > steps ? length : length * (k - 1) / steps;
      if (to - from > longest + 1e-6) {
        longest = to - from;
        const Point start = sign > 0 ? piece.from : piece.to;
        best = {"", 0, start + from * (sign * along), start + to * (sign * along)};
      }
      from = -1;
    }
  }
  if (longest < kLeastLength * ground.machine.working_width_m) return std::nullopt;
  return best;
}

}  // namespace

std::vector<Swath> lay_pockets(const Ground& ground, const Layout& layout) {
  const double width = ground.machine.working_width_m;
  std::vector<Swath> pockets;
  for (int round = 0; round < kRounds; ++round) {
    const Polygons left = subtract(ground.workable, covered_by(ground, layout, pockets));
    const std::size_t before = pockets.size();
    for (const Polygon& part : outset_round(inset_round(left, kSliver_m), kSliver_m)) {
      if (area_m2(part) < kPassWorth * width * width) continue;
      for (const Swath& piece : pieces_over(ground, part))
        if (auto fit = fitted(ground, piece)) pockets.push_back(*fit);
    }
    if (pockets.size() == before) break;
  }
  for (std::size_t k = 0; k < pockets.size(); ++k) pockets[k].id = "P" + std::to_string(k + 1);
  return pockets;
}

}  // namespace selion
