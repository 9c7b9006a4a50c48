// SPDX-License-Identifier: GPL-3.0-or-later
// Why a block has no linear layout: what it would take, and what there is.
#include <algorithm>
#include <string>

#include "parts.hpp"
#include "selion/core/format.hpp"

namespace selion {
namespace {

/// Diameter of the largest circle inside, to a centimetre.
double widest_m(const Polygons& areas) {
  double low = 0;
  double high = 0;
  for (const Polygon& area : areas) {
    const Box box = bounds(area.shell);
    high = std::max(high, std::min(box.high.x_m - box.low.x_m, box.high.y_m - box.low.y_m));
  }
  while (high - low > 0.01) {
    const double middle = (low + high) / 2;
    (inset_round(areas, middle / 2).empty() ? high : low) = middle;
  }
  return low;
}

/// Without a headland: of ground that a swath could be laid on, and how far the machine reaches along it.
Infeasible no_swath(const Ground& ground, const Polygons& all, double depth_m) {
  const Machine& machine = ground.machine;
  const double need = 2 * (ground.edge_margin_m + ground.half_m);
  const double have = widest_m(all);
  const double length =
      std::max(machine.front_m, machine.tool_x_m) + std::max(machine.rear_m, -machine.tool_x_m);
  const std::string swath = "a swath needs straight ground " + fixed(need, 1) + " m wide and more than " +
                            fixed(length, 1) + " m long, the block is " + fixed(have, 1) +
                            " m wide at its widest place";
  if (have < need) return Infeasible{"too narrow: " + swath + "; a narrower machine may do"};
  if (!machine.may_reverse)
    return Infeasible{
        "too narrow: a machine that may not reverse gets into or out of no swath: a U-turn is " +
        fixed(depth_m, 1) + " m deep, the block is " + fixed(have, 1) +
        " m wide at its widest place; one that may reverse may do"};
  return Infeasible{"too small or too crooked: " + swath +
                    " and no swath fits there; a smaller machine or another direction may do"};
}

}  // namespace

Infeasible too_narrow(const Ground& ground, const Polygons& all, int passes, double depth_m, bool as_told) {
  if (passes == 0) return no_swath(ground, all, depth_m);
  const double have = widest_m(all);
  const double need = 2 * (ground.edge_margin_m + mainland_inset_m(ground, passes));
  if (have >= need)
    return Infeasible{"too small or too crooked: inside the headlands (" + std::to_string(passes) +
                      (passes == 1 ? " pass" : " passes") + ", together " + fixed(need, 1) +
                      " m of width), no swath fits; the block is " + fixed(have, 1) +
                      " m wide at its widest place; a smaller machine" +
                      (as_told ? ", or fewer headland passes, may do" : " may do")};
  return Infeasible{"too narrow: the headlands need " + fixed(need, 1) + " m of width (" +
                    std::to_string(passes) + (passes == 1 ? " pass" : " passes") + " of " +
                    fixed(ground.machine.working_width_m, 2) + " m on either side; a U-turn is " +
                    fixed(depth_m, 1) + " m deep), the block is " + fixed(have, 1) +
                    " m wide at its widest place; a narrower or more agile machine" +
                    (as_told ? ", or fewer headland passes, may do" : " may do")};
}

}  // namespace selion
