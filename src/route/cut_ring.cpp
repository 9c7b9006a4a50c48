// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_ring.hpp"

#include <cmath>
#include <utility>

#include "roads.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr double kOnLine = 1e-6;  // m, rad

/// How far along a straight a pose lies that points the same way.
std::optional<double> place_on(const Stretch& stretch, const Pose& pose) {
  const Curve& curve = stretch.curve;
  if (curve.curvature_per_m != 0 || curve.sharpness_per_m2 != 0) return std::nullopt;
  if (std::abs(wrapped(curve.heading_rad - pose.heading_rad)) > kOnLine) return std::nullopt;
  const Point along = unit(curve.heading_rad);
  const Point way = pose.at - curve.start;
  const double s_m = dot(way, along);
  if (std::abs(cross(along, way)) > kOnLine || s_m < 0 || s_m > curve.length_m) return std::nullopt;
  return s_m;
}

}  // namespace

std::optional<PartPlace> place_on(const HeadlandPass& ring, const Pose& pose) {
  for (std::size_t part = 0; part < ring.parts.size(); ++part) {
    double before_m = 0;
    for (const Stretch& stretch : ring.parts[part].path) {
      if (const auto s_m = place_on(stretch, pose)) return PartPlace{part, before_m + *s_m};
      before_m += stretch.curve.length_m;
    }
  }
  return std::nullopt;
}

Task part_task(const HeadlandPass& ring, const Path& path) {
  Task task{PieceKind::headland_pass, ring.id, {}, {}};
  task.add_line(path);
  return task;
}

Task cut_ring_task(const Terrain& terrain, const HeadlandPass& ring, const std::optional<Pose>& here,
                   const std::vector<Point>& then_to) {
  const Task round = closed_pass_task(terrain, ring, here, Round::as_laid, then_to);
  Task task{PieceKind::headland_pass, ring.id, {}, {}};
  for (const Way& way : round.ways) {
    const auto begin = place_on(ring, way.start);
    if (!begin) continue;
    const Path& part = ring.parts[begin->part].path;
    task.ways.push_back({task.lines.size(), 0, way.start, way.rest_m});
    task.lines.push_back(part_of(part, begin->s_m, length_m(part)));
  }
  return task;
}

}  // namespace selion
