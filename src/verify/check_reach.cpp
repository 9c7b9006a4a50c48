// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "segments.hpp"

namespace selion::verifying {
namespace {

constexpr double kBeside_m = 100;  // of the block: what is nearer is followed, and found outside
constexpr double kMostWay = 10;    // times what covers the block once and leads round it once
constexpr double kMostWork = 1.5;  // times the lines that it is said to work, and
constexpr double kMoreWork_m = 300;
constexpr double kMostRobots = 3;  // times the lines that all robots of a block work together

bool beside(const Box& box, Point p) {
  return p.x_m > box.low.x_m - kBeside_m && p.x_m < box.high.x_m + kBeside_m &&
         p.y_m > box.low.y_m - kBeside_m && p.y_m < box.high.y_m + kBeside_m;
}

/// A curve that stays there can be longer than the block only by turning.
bool longer_than(const Box& box, const PieceRecord& p) {
  const double end = p.curvature_per_m + p.sharpness_per_m2 * p.length_m;
  const double turned = (std::abs(p.curvature_per_m) + std::abs(end)) / 2 * p.length_m;
  return p.length_m > (distance_m(box.low, box.high) + kBeside_m) * (1 + turned);
}

std::string what_is_absurd(const Box& box, const PieceRecord& piece) {
  if (!beside(box, {piece.x_m, piece.y_m})) return " begins more than 100 m away from its block";
  if (longer_than(box, piece)) return " is " + shown(piece.length_m, 0) + " m long, more than its block";
  return "";
}

bool check_pieces(Case& plan, const TrajectoryRecord& t, const Box& box) {
  for (std::size_t i = 0; i < t.pieces.size(); ++i) {
    const PieceRecord& piece = t.pieces[i];
    const std::string what = what_is_absurd(box, piece);
    if (what.empty()) continue;
    plan.findings.add("piece", t.block, Point{piece.x_m, piece.y_m}, {piece.length_m, 0},
                      "robot " + std::to_string(t.robot) + ", piece " + std::to_string(i + 1) + " (" +
                          piece.kind + ")" + what + "; no piece of this trajectory is followed");
    return false;
  }
  return true;
}

double length_m(const Plane& plane, const LonLatLine& line) {
  const std::vector<Point> points = plane.to_local(line);
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance_m(points[i - 1], points[i]);
  return sum;
}

/// Of the swaths and headland passes that the block is said to have.
double lines_m(const Case& plan, int block) {
  double sum = 0;
  for (const SwathRecord& swath : plan.plan.swaths)
    if (swath.block == block) sum += length_m(plan.plane, swath.line);
  for (const HeadlandPassRecord& pass : plan.plan.headland_passes)
    if (pass.block == block) sum += length_m(plan.plane, pass.line);
  return sum;
}

bool check_ways(Case& plan, const TrajectoryRecord& t, const Shape& area) {
  double way = 0;
  double work = 0;
  for (const PieceRecord& piece : t.pieces) way += piece.length_m, work += piece.tool * piece.length_m;
  const double once = area_m2(area) / plan.vehicle.machine.working_width_m + perimeter_m(area);
  const double lines = lines_m(plan, t.block);
  const auto refuse = [&](Measured way_m, const std::string& what) {
    plan.findings.add(
        "piece", t.block, std::nullopt, way_m,
        "robot " + std::to_string(t.robot) + what + "; no piece of this trajectory is followed");
    return false;
  };
  if (!(way <= kMostWay * once))
    return refuse(
        {way, kMostWay * once},
        " drives " + shown(way / 1000, 1) + " km; to work the block takes " + shown(once / 1000, 1) + " km");
  if (!(work <= kMostWork * lines + kMoreWork_m))
    return refuse({work, lines}, " works on " + shown(work / 1000, 2) + " km; all swaths and passes have " +
                                     shown(lines / 1000, 2) + " km");
  return true;
}

/// Robots that work the same over and over: each for itself may be sound.
bool check_all_ways(Case& plan, int block) {
  double work = 0;
  for (const TrajectoryRecord& t : plan.plan.trajectories)
    for (const PieceRecord& piece : t.pieces) work += t.block == block ? piece.tool * piece.length_m : 0;
  const double most = kMostRobots * (lines_m(plan, block) + kMoreWork_m);
  if (work <= most) return true;
  plan.findings.add("piece", block, std::nullopt, {work, most},
                    "the block's robots work on " + shown(work / 1000, 2) +
                        " km; no piece of their trajectories is followed");
  return false;
}

}  // namespace

bool check_reach(Case& plan) {
  bool sound = true;
  for (const TrajectoryRecord& t : plan.plan.trajectories) {
    const Ground* ground = plan.ground(t.block);
    if (ground == nullptr) continue;
    sound = check_pieces(plan, t, box_of(ground->area)) && check_ways(plan, t, ground->area) && sound;
  }
  for (const Ground& ground : plan.grounds) sound = sound && check_all_ways(plan, ground.block);
  return sound;
}

}  // namespace selion::verifying
