// SPDX-License-Identifier: GPL-3.0-or-later
#include "records.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "selion/core/angle.hpp"

namespace selion {
namespace {

std::string name_of(ObstacleKind kind) {
  if (kind == ObstacleKind::water) return "water";
  return kind == ObstacleKind::no_go ? "no_go" : "obstacle";
}

LonLatLine to_lonlat(const LocalFrame& frame, const std::vector<Point>& points) {
  LonLatLine line;
  line.reserve(points.size());
  for (const Point p : points) line.push_back(frame.to_lonlat(p));
  return line;
}

PieceRecord record_of(const DrivePiece& piece) {
  const Curve& curve = piece.leg.stretch.curve;
  PieceRecord record;
  record.kind = piece.kind;
  record.ref = piece.ref;
  record.x_m = curve.start.x_m;
  record.y_m = curve.start.y_m;
  record.heading_rad = wrapped(curve.heading_rad);
  record.curvature_per_m = curve.curvature_per_m;
  record.sharpness_per_m2 = curve.sharpness_per_m2;
  record.length_m = curve.length_m;
  record.gear = static_cast<int>(piece.leg.stretch.gear);
  record.tool = piece.leg.tool_down ? 1 : 0;
  if (is_pivot(piece.leg.stretch)) record.angle_rad = piece.leg.stretch.pivot_rad;
  if (piece.leg.wait_s > 0) record.duration_s = piece.leg.wait_s;
  return record;
}

/// Gain of speed in time.
double slope_mps2(const Sample& from, const Sample& to) {
  return (std::abs(to.speed_mps) - std::abs(from.speed_mps)) / (to.t_s - from.t_s);
}

/// May the later one of two samples go? It may not where the tool changes. The earlier one may where braking
/// does not end there: the chord that is left is slower than the two.
bool later_goes(const std::vector<Sample>& kept, const Sample& later) {
  if (kept.size() < 2 || kept.back().tool_down != later.tool_down) return false;
  return slope_mps2(kept[kept.size() - 2], kept.back()) < slope_mps2(kept.back(), later);
}

/// Of samples at one time as the file writes it, one.
std::vector<Sample> distinct(const std::vector<Sample>& samples) {
  constexpr double kTicks_per_s = 1e4;  // four decimals
  std::vector<Sample> kept;
  for (const Sample& sample : samples) {
    const bool same = !kept.empty() &&
                      std::llround(sample.t_s * kTicks_per_s) <= std::llround(kept.back().t_s * kTicks_per_s);
    if (!same)
      kept.push_back(sample);
    else if (&sample == &samples.back() || !later_goes(kept, sample))
      kept.back() = sample;
  }
  return kept;
}

TrajectoryRecord trajectory_of(int block, const Drive& drive, const LocalFrame& frame,
                               const Machine& machine) {
  TrajectoryRecord record;
  record.block = block;
  record.working_width_m = machine.working_width_m;
  for (const DrivePiece& piece : drive.pieces) {
    record.pieces.push_back(record_of(piece));
    record.length_m += piece.leg.stretch.curve.length_m;
  }
  for (const Sample& sample : distinct(drive.samples)) {
    record.line.push_back(frame.to_lonlat(sample.at));
    record.t_s.push_back(sample.t_s);
    record.heading_rad.push_back(sample.heading_rad);
    record.curvature_per_m.push_back(sample.curvature_per_m);
    record.speed_mps.push_back(sample.speed_mps);
    record.tool.push_back(sample.tool_down ? 1 : 0);
  }
  record.duration_s = drive.samples.empty() ? 0 : drive.samples.back().t_s;
  return record;
}

void add_swaths(PlanFile& file, const PlannedBlock& planned, const LocalFrame& frame,
                const Machine& machine) {
  std::map<std::string, int> order;
  for (const RoutePiece& piece : planned.route.pieces)
    if (piece.kind == PieceKind::swath) order.emplace(piece.ref, static_cast<int>(order.size()) + 1);
  const auto add = [&](const Swath& swath, const std::string& cell) {
    const auto place = order.find(swath.id);
    if (place == order.end())
      return;  // not driven: named among the notes, and its ground among the uncovered
    file.swaths.push_back({planned.block.number, swath.id, cell,
                           to_lonlat(frame, std::vector<Point>{swath.from, swath.to}),
                           machine.working_width_m, distance_m(swath.from, swath.to), place->second});
  };
  for (const Swath& swath : planned.layout.swaths) add(swath, "1");
  for (const Swath& pocket : planned.layout.pockets) add(pocket, "");
}

/// What is driven, its curves as chords.
std::vector<Point> line_of(const Path& path) {
  constexpr double kChord_m = 0.25;  // as the trajectory's samples on curves
  std::vector<Point> line;
  for (const Stretch& stretch : path) {
    const bool bent = stretch.curve.curvature_per_m != 0 || stretch.curve.sharpness_per_m2 != 0;
    for (const Pose& pose : poses({stretch}, bent ? kChord_m : stretch.curve.length_m))
      if (line.empty() || distance_m(line.back(), pose.at) > 1e-6) line.push_back(pose.at);
  }
  return line;
}

/// Of the pass "H3", or of its part "H3b".
int ring_of(const Layout& layout, const std::string& id) {
  const std::string pass = id.substr(0, id.find_last_of("0123456789") + 1);
  const auto laid = std::find_if(layout.headland_passes.begin(), layout.headland_passes.end(),
                                 [&pass](const HeadlandPass& p) { return p.id == pass; });
  return laid == layout.headland_passes.end() ? 0 : laid->ring;
}

void add_headland(PlanFile& file, const PlannedBlock& planned, const LocalFrame& frame,
                  const Machine& machine) {
  HeadlandRecord band{planned.block.number, {}, planned.layout.headland_depth_m, planned.layout.passes};
  for (const Polygon& part : planned.layout.headland) band.parts.push_back(to_lonlat(frame, part));
  if (!band.parts.empty()) file.headlands.push_back(std::move(band));
  for (const RoutePiece& piece : planned.route.pieces) {
    if (piece.kind != PieceKind::headland_pass) continue;
    file.headland_passes.push_back({planned.block.number, piece.ref, ring_of(planned.layout, piece.ref),
                                    to_lonlat(frame, line_of(piece.path)), machine.working_width_m});
  }
}

}  // namespace

LonLatArea to_lonlat(const LocalFrame& frame, const Polygon& area) {
  LonLatArea out{to_lonlat(frame, area.shell), {}};
  for (const Ring& hole : area.holes) out.holes.push_back(to_lonlat(frame, hole));
  return out;
}

double true_bearing_deg(const LocalFrame& frame, Point p, double heading_rad) {
  const double bearing = std::fmod(frame.bearing_deg(p, unit(heading_rad)) + 360, 360);
  return bearing >= 359.99999 ? 0 : bearing;  // what rounding leaves of north
}

void add_records(PlanFile& file, const PlannedBlock& planned, const Drive& drive, const LocalFrame& frame,
                 const Machine& machine) {
  const Block& block = planned.block;
  for (const BlockObstacle& obstacle : block.obstacles)
    file.obstacles.push_back(
        {block.number, to_lonlat(frame, obstacle.area), obstacle.name, name_of(obstacle.kind)});
  const AbLine& ab = planned.layout.ab;
  const double bearing = true_bearing_deg(frame, ab.a, heading_rad(ab.b - ab.a));
  CellRecord cell{block.number, "1", {}, std::fmod(bearing, 180)};
  for (const Polygon& part : planned.layout.mainland) cell.parts.push_back(to_lonlat(frame, part));
  if (!cell.parts.empty()) file.cells.push_back(std::move(cell));
  file.ab_lines.push_back({block.number, frame.to_lonlat(ab.a), frame.to_lonlat(ab.b), bearing});
  add_headland(file, planned, frame, machine);
  add_swaths(file, planned, frame, machine);
  file.trajectories.push_back(trajectory_of(block.number, drive, frame, machine));
}

}  // namespace selion
