// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_legs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace selion {
namespace {

constexpr double kNothing_m = 1e-6;

/// The parts of a ring while they grow leg by leg.
class Parts {
 public:
  /// A side, begun `back_m` before it.
  void add_side(const Stretch& side, double back_m) {
    Curve longer = side.curve;
    longer.start = longer.start - back_m * unit(longer.heading_rad);
    longer.length_m += back_m;
    path_.push_back({longer, side.gear});
  }
  void add_bend(const Path& bend) { append(path_, bend); }
  /// Ends the part that leads to a filled corner, and works its bend where that is to be.
  void fill(const Path& bend, const Fill& fill) {
    path_.back().curve.length_m += fill.on_m;
    if (!fill.round) return close(fill.way);
    if (fill.on_m > 0) close(straight(end_pose(path_), -fill.on_m));
    add_bend(bend);
    close(straight(end_pose(path_), -fill.back_m));
  }
  std::vector<HeadlandPart> take() && { return std::move(parts_); }

 private:
  void close(Path way_on) { parts_.push_back({std::exchange(path_, {}), std::move(way_on)}); }

  Path path_;
  std::vector<HeadlandPart> parts_;
};

}  // namespace

std::vector<RingLeg> legs_of(const Path& closed, double least_side_m) {
  const auto is_side = [&](const Stretch& stretch) {
    return is_straight(stretch.curve) && stretch.curve.length_m >= least_side_m;
  };
  Path path = closed;
  std::rotate(path.begin(), std::find_if(path.begin(), path.end(), is_side), path.end());
  std::vector<RingLeg> legs;
  for (const Stretch& stretch : path) {
    if (is_side(stretch))
      legs.push_back({stretch, {}});
    else if (!legs.empty())
      legs.back().bend.push_back(stretch);
  }
  return legs;
}

std::optional<LeftTurn> left_turn(const Path& bend) {
  constexpr double kStraight_per_m = 1e-9;
  double turned_rad = 0;
  for (const Stretch& stretch : bend) {
    const CurveState end = end_of(stretch.curve);
    if (std::min(stretch.curve.curvature_per_m, end.curvature_per_m) < -kStraight_per_m) return std::nullopt;
    turned_rad += end.heading_rad - stretch.curve.heading_rad;
  }
  constexpr double kLeast_rad = 0.1;
  if (turned_rad < kLeast_rad || turned_rad > std::numbers::pi - kLeast_rad) return std::nullopt;
  LeftTurn turn{start_pose(bend), end_pose(bend), turned_rad};
  const Point before = unit(turn.in.heading_rad);
  const Point after = unit(turn.out.heading_rad);
  const Point chord = turn.out.at - turn.in.at;
  turn.before_m = cross(chord, after) / cross(before, after);
  turn.after_m = cross(before, chord) / cross(before, after);
  return turn;
}

Pose on_from(const Pose& pose, double by_m) {
  return {pose.at + by_m * unit(pose.heading_rad), pose.heading_rad};
}

Path straight(const Pose& from, double by_m) {
  if (std::abs(by_m) < kNothing_m) return {};
  return {{line(from.at, on_from(from, by_m).at), by_m > 0 ? Gear::forward : Gear::reverse}};
}

std::vector<HeadlandPart> cut(const std::vector<RingLeg>& legs,
                              const std::vector<std::optional<Fill>>& fills) {
  const auto first =
      std::find_if(fills.begin(), fills.end(), [](const auto& fill) { return fill.has_value(); });
  const auto last = static_cast<std::size_t>(first - fills.begin());
  Parts parts;
  double back_m = (*first)->back_m;
  for (std::size_t k = 1; k <= legs.size(); ++k) {
    const std::size_t i = (last + k) % legs.size();
    parts.add_side(legs[i].side, back_m);
    if (fills[i])
      parts.fill(legs[i].bend, *fills[i]);
    else
      parts.add_bend(legs[i].bend);
    back_m = fills[i] ? fills[i]->back_m : 0;
  }
  return std::move(parts).take();
}

}  // namespace selion
