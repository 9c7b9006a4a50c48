// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kMargin_m = 0.02;

std::array<Point, 4> worked(const Machine& machine, const PieceLine& swath) {
  const double half = machine.working_width_m / 2;
  const Pose from = swath.vehicle(0);
  const Pose to = swath.vehicle(swath.length_m());
  return {placed(from, {machine.tool_x_m, -half}), placed(to, {machine.tool_x_m, -half}),
          placed(to, {machine.tool_x_m, half}), placed(from, {machine.tool_x_m, half})};
}

/// To what makes no difference to the margin.
bool is_straight(const PieceLine& swath) {
  return swath.most_curvature_per_m() * swath.length_m() * swath.length_m() < kMargin_m;
}

}  // namespace

void check_margin(Case& plan, const Driven& driven) {
  const Ground* ground = plan.ground(driven.record->block);
  const double margin = plan.vehicle.edge_margin_m;
  if (ground == nullptr || !(margin > 0)) return;
  const Prepared border{ground->edge};
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
    const PieceLine& piece = driven.pieces[i];
    if (piece.record().kind != "swath" || !is_straight(piece)) continue;
    const double off = border.distance_m(worked(plan.vehicle.machine, piece));
    if (!(off >= margin - kMargin_m))
      plan.findings.add("edge_margin", ground->block, piece.spot(0).at, {off, margin},
                        piece_name(driven, i) + " works " + shown(off, 3) + " m from the border; " +
                            shown(margin, 3) + " m are to be kept from it");
  }
}

}  // namespace selion::verifying
