// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/geometry/polygon.hpp"
#include "selion/output/map.hpp"

namespace selion {

/// What a sample plan is made of; lengths in the local frame.
struct SampleField {
  std::vector<Polygon> parts;
  double width_m = 3;
  double headland_m = 9;
  double bearing_deg = 0;
};

/// A plan up and down each part, with headland passes, arcs as turns, an AB line, a start and an end. It is
/// drivable only on paper: the map must show it, nobody drives it.
PlanFile sample_plan(const SampleField& field);
MapText sample_text();

Polygon rectangle(Point corner, double width_m, double height_m);

}  // namespace selion
