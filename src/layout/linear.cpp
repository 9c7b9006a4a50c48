// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "kinds.hpp"
#include "parts.hpp"
#include "selion/core/format.hpp"

namespace selion {
namespace {

int passes_for(const Ground& ground, double depth_m) {
  int passes = 1;
  while (ground.edge_margin_m + mainland_inset_m(ground, passes) < depth_m) ++passes;
  return passes;
}

/// Rings until they meet; absent where there would be so many that swaths are what is needed.
std::optional<int> passes_that_meet(const Ground& ground) {
  constexpr int kMost = 4;
  int passes = 0;
  while (!inset(ground.workable, ring_inset_m(ground, passes + 1)).empty())
    if (++passes > kMost) return std::nullopt;
  return passes > 0 ? std::optional{passes} : std::nullopt;
}

/// The longest straight of the passes; with a heading that was asked for, a line at a corner.
AbLine line_beside(const Ground& ground, const Layout& layout, const LayoutOptions& options) {
  if (options.ab) return *options.ab;
  if (options.heading_rad) {
    const Point corner = ground.workable.front().shell.front();
    return {corner, corner + 2 * ground.machine.working_width_m * unit(*options.heading_rad)};
  }
  Curve longest;
  for (const HeadlandPass& pass : layout.headland_passes)
    for (const Stretch& stretch : pass.path)
      if (is_straight(stretch.curve) && stretch.curve.length_m > longest.length_m) longest = stretch.curve;
  return {longest.start, end_of(longest).at};
}

void add_mainland(Layout& layout, const Block& block, const Ground& ground) {
  layout.headland_depth_m = ground.edge_margin_m + mainland_inset_m(ground, layout.passes);
  layout.mainland = inset(ground.workable, mainland_inset_m(ground, layout.passes));
  layout.headland = subtract({block.area}, layout.mainland);
}

Result<Layout> lay_passes_alone(Layout layout, const Block& block, const Ground& ground,
                                const LayoutOptions& options) {
  layout.passes = passes_that_meet(ground).value_or(0);
  layout.headland_passes = lay_headland(ground, layout.passes);
  lay_between(ground, layout.passes, layout.headland_passes);
  if (layout.headland_passes.empty())
    return Infeasible{"headland passes alone are for ground hardly wider than the machine"};
  layout.passes = layout.headland_passes.back().ring;  // the innermost one may be too small to be driven
  add_mainland(layout, block, ground);
  layout.ab = line_beside(ground, layout, options);
  layout.pockets = lay_pockets(ground, layout);
  return layout;
}

}  // namespace

int passes_for_turns(const Block& block, const Machine& machine, const LayoutOptions& options) {
  return passes_for(ground_of(block, machine, options.edge_margin_m),
                    turn_depth_m(machine, machine.working_width_m - options.overlap_m));
}

Result<Layout> lay_linear(const Block& block, const Machine& machine, const LayoutOptions& options) {
  const Ground ground = ground_of(block, machine, options.edge_margin_m, options.border_room_m);
  Layout layout;
  layout.along =
      options.ab ? DrivingDirection::radians(heading_rad(options.ab->b - options.ab->a)) : options.along;
  layout.turn_depth_m = turn_depth_m(machine, machine.working_width_m - options.overlap_m);
  if (options.interior == Interior::nothing)
    return lay_passes_alone(std::move(layout), block, ground, options);
  layout.passes = options.passes.value_or(passes_for(ground, layout.turn_depth_m));
  add_mainland(layout, block, ground);
  const auto refuse = [&] {
    return too_narrow(ground, {block.area}, layout.passes, layout.turn_depth_m, options.passes.has_value());
  };
  if (layout.mainland.empty()) return refuse();
  if (layout.headland_depth_m < layout.turn_depth_m)
    layout.notes.push_back("the headland is " + fixed(layout.headland_depth_m, 1) +
                           " m deep, a U-turn needs " + fixed(layout.turn_depth_m, 1) +
                           " m: the machine has to turn by other ways");
  layout.headland_passes = lay_headland(ground, layout.passes);
  // Shorter ones inside the headland cross a sliver beside it, which pockets work lengthwise.
  const double least_m = layout.passes > 0 ? machine.working_width_m : 0;
  layout.swaths = lay_swaths(ground, layout.mainland, options, least_m, layout.ab);
  if (layout.swaths.empty()) return refuse();
  if (options.corners == HeadlandCorners::fill) fill_corners(ground, layout);
  layout.pockets = lay_pockets(ground, layout);
  return layout;
}

}  // namespace selion
