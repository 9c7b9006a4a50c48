// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "selion/layout/layout.hpp"
#include "selion/motion/footprint.hpp"

namespace selion {

/// How far the lines of headland passes may stray from their rings; rings overlap by twice as much so that no
/// sliver stays between.
constexpr double kFollow_m = 0.01;

/// From where to where something lies along an axis.
struct AxisExtent {
  double low_m = std::numeric_limits<double>::infinity();
  double high_m = -std::numeric_limits<double>::infinity();

  void take(double value_m) {
    low_m = std::min(low_m, value_m);
    high_m = std::max(high_m, value_m);
  }
};
AxisExtent extent_of(const Polygons& areas, Point axis);
inline double length_m(AxisExtent extent) { return extent.high_m - extent.low_m; }

/// The distances and limits that all parts of a linear layout share.
struct Ground {
  Machine machine;
  Footprint footprint;
  FreeSpace space;    ///< where body and tool may be
  Polygons workable;  ///< where the tool is to work: the free area less the edge margin
  double half_m = 0;  ///< of the wider of tool and body
  double edge_margin_m = 0;
  double border_room_m = 0;  ///< more for the outermost passes, to swing out
  Swings swings;             ///< at turn speed
};

Ground ground_of(const Block& block, const Machine& machine, double edge_margin_m, double border_room_m = 0);

/// Of the piece's part that fits, driven from `from`, what a machine that only drives forwards can get to and
/// away from; all of it for one that may reverse.
AxisExtent without_dead_ends(const Ground& ground, const Swath& way, AxisExtent fit);

/// How far tool, body and axle go beyond the end of a swath in the U-turn to its neighbour, the end square to
/// the swath.
double turn_depth_m(const Machine& machine, double spacing_m);

/// Why no swath lies inside so many headland passes, which were `as_told` or what turns need.
/// @param depth_m of a U-turn
Infeasible too_narrow(const Ground& ground, const Polygons& all, int passes, double depth_m, bool as_told);

/// From the workable area's border to the axle's ring `ring` (from 1), and to the swaths' area inside
/// `passes` rings.
double ring_inset_m(const Ground& ground, int ring);
double mainland_inset_m(const Ground& ground, int passes);

std::vector<HeadlandPass> lay_headland(const Ground& ground, int passes);
/// One more ring, in the middle of what the innermost of `passes` leave between them, where that is too
/// narrow for one beside them.
void lay_between(const Ground& ground, int passes, std::vector<HeadlandPass>& laid);

/// A drivable path, all around or a part of the way.
struct HeadlandRun {
  Path path;
  bool closed = true;
};

/// Paths along `ring` (its free side on the left), rounded inwards at left turns and swung out at right
/// turns: one closed path where the machine can go round, else the runs that it can drive. Body and tool may
/// swing out of the lane by `room_m`.
std::vector<HeadlandRun> drivable_along(const Ground& ground, const Ring& ring, double room_m);

/// Of at least `least_m`, unless all are shorter.
std::vector<Swath> lay_swaths(const Ground& ground, const Polygons& mainland, const LayoutOptions& options,
                              double least_m, AbLine& ab);

/// What of the workable ground headland passes, swaths and these pocket pieces leave.
Polygons unworked(const Ground& ground, const Layout& layout, const std::vector<Swath>& pockets);

/// Cuts closed passes at left turns that leave ground unworked, so that it is worked (corner_fill.cpp).
void fill_corners(const Ground& ground, Layout& layout);

/// Straight pieces over what headland and swaths leave unworked, where it is worth a pass.
std::vector<Swath> lay_pockets(const Ground& ground, const Layout& layout);

/// The part of the strip around a-b (the tool's centre line) over which the tool can be driven, as spans from
/// a.
std::vector<Span1> drivable_spans(const Ground& ground, Point a, Point b);

Ring strip(Point a, Point b, double width_m);

}  // namespace selion
