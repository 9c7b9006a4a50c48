// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "check.hpp"
#include "taken_apart.hpp"

namespace selion {
namespace {

using namespace verifying;

constexpr std::size_t kMost = 10;
constexpr double kApart_m = 5;

struct Candidate {
  double measure_m = 0;
  Point at;
  double way_m = 0;
  const Driven* driven = nullptr;
  std::size_t piece = 0;
  bool obstacle = false;
};

/// The nearest ones, no two of them within five metres.
std::vector<Candidate> spread_out(std::vector<Candidate> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.measure_m < b.measure_m; });
  std::vector<Candidate> kept;
  for (const Candidate& c : all) {
    if (kept.size() == kMost) break;
    const bool near =
        std::ranges::any_of(kept, [&](const Candidate& k) { return distance_m(k.at, c.at) < kApart_m; });
    if (!near) kept.push_back(c);
  }
  return kept;
}

/// Body and tool as one set of corners.
std::vector<Point> outline_at(const Machine& m, const Pose& pose) {
  const double body = m.body_width_m / 2;
  const double tool = m.working_width_m / 2;
  return {placed(pose, {-m.rear_m, -body}), placed(pose, {m.front_m, -body}),
          placed(pose, {m.front_m, body}),  placed(pose, {-m.rear_m, body}),
          placed(pose, {m.tool_x_m, tool}), placed(pose, {m.tool_x_m, -tool})};
}

/// Nearest of what stands around: the border, or a hole or obstacle in it.
struct Surroundings {
  Prepared border;
  std::optional<Prepared> obstacles;
};

Surroundings around(const Ground& ground) {
  std::vector<Shape> shells;
  std::vector<Shape> holes;
  for (const Outline& outline : outlines_of(ground.area)) {
    shells.push_back(border_of(polygon_of(outline.shell)));
    for (const auto& hole : outline.holes) holes.push_back(polygon_of(hole));
  }
  if (ground.obstacles) holes.push_back(ground.obstacles);
  Surroundings surroundings{Prepared{united(shells)}, std::nullopt};
  if (!holes.empty()) surroundings.obstacles.emplace(united(holes));
  return surroundings;
}

double nearest_m(const Prepared& to, const std::vector<Point>& outline) {
  const double body = to.distance_m(std::span{outline}.first(4));
  return std::min(body, to.distance_m(std::span{outline}.last(2)));
}

/// All places nearer than `near_m`, and some others: by as far as it is to what stands around, less what the
/// body reaches round the axle, nothing can come near.
void add_approaches(std::vector<Candidate>& all, const Case& plan, const Driven& driven, const Ground& ground,
                    double near_m) {
  constexpr double kStep_m = 0.5;
  const Surroundings surroundings = around(ground);
  double reach_m = 0;
  for (const Point corner : outline_at(plan.vehicle.machine, {}))
    reach_m = std::max(reach_m, length_m(corner));
  const int steps = std::max(1, static_cast<int>(std::ceil(driven.whole_m() / kStep_m)));
  for (int i = 0; i <= steps;) {
    const double way = driven.whole_m() * i / steps;
    const Stop here = driven.stop(way);
    const Pose pose = driven.pieces[here.piece].vehicle(here.s_m);
    const auto outline = outline_at(plan.vehicle.machine, pose);
    double nearest = nearest_m(surroundings.border, outline);
    all.push_back({nearest, pose.at, way, &driven, here.piece, false});
    if (surroundings.obstacles) {
      all.push_back({nearest_m(*surroundings.obstacles, outline), pose.at, way, &driven, here.piece, true});
      nearest = std::min(nearest, all.back().measure_m);
    }
    i += static_cast<int>(std::clamp((nearest - near_m - reach_m) / kStep_m, 1.0, 1.0 + steps));
  }
}

void add_bends(std::vector<Candidate>& all, const Driven& driven) {
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
    const PieceLine& piece = driven.pieces[i];
    if (piece.straight() || !(piece.length_m() > 0)) continue;
    const bool first =
        std::abs(piece.curvature_per_m(0)) >= std::abs(piece.curvature_per_m(piece.length_m()));
    const double s = first ? 0 : piece.length_m();
    all.push_back({1 / piece.most_curvature_per_m(), piece.spot(s).at, driven.begin_m[i] + piece.driven_m(s),
                   &driven, i, false});
  }
}

/// Near places first: only where these are too few are all others looked at.
std::vector<Candidate> closest_approaches(const Case& plan) {
  std::vector<Candidate> kept;
  for (const double near_m : {2.0, std::numeric_limits<double>::infinity()}) {
    std::vector<Candidate> all;
    for (const Driven& driven : plan.drives)
      if (const Ground* ground = plan.ground(driven.record->block))
        add_approaches(all, plan, driven, *ground, near_m);
    kept = spread_out(std::move(all));
    if (kept.size() == kMost && kept.back().measure_m <= near_m) break;
  }
  return kept;
}

WatchPlace place_of(const Case& plan, const Candidate& c, std::string what) {
  return {std::move(what),
          c.driven->record->block,
          c.driven->record->robot,
          plan.plane.to_lonlat(c.at),
          c.driven->moments.empty() ? 0 : time_s(*c.driven, c.way_m),
          c.measure_m};
}

}  // namespace

WatchList watch_list(const PlanFile& plan) {
  TakenApart taken{plan};
  if (!taken.usable()) return {};
  Case& apart = taken.plan();
  std::vector<Candidate> bends;
  for (Driven& driven : apart.drives) {
    check_samples(apart, driven);
    add_bends(bends, driven);
  }
  WatchList list;
  for (const Candidate& c : closest_approaches(apart))
    list.closest.push_back(place_of(apart, c, c.obstacle ? "obstacle" : "border"));
  for (const Candidate& c : spread_out(std::move(bends))) {
    const PieceRecord& piece = c.driven->pieces[c.piece].record();
    list.tightest.push_back(place_of(apart, c, piece.kind + (piece.ref.empty() ? "" : " " + piece.ref)));
  }
  return list;
}

}  // namespace selion
