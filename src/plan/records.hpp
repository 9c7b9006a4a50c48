// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coverage.hpp"
#include "drive.hpp"
#include "selion/field/block.hpp"
#include "selion/field/frame.hpp"
#include "selion/layout/layout.hpp"
#include "selion/plan/job.hpp"
#include "selion/plan/plan.hpp"
#include "selion/planfile/planfile.hpp"
#include "selion/route/route.hpp"

namespace selion {

/// A block with everything that was found for it.
struct PlannedBlock {
  Block block;
  Layout layout;
  Route route;
  Coverage coverage;
};

LonLatArea to_lonlat(const LocalFrame& frame, const Polygon& area);

/// Adds all records of the block to the file.
void add_records(PlanFile& file, const PlannedBlock& planned, const Drive& drive, const LocalFrame& frame,
                 const Machine& machine);

/// True bearing of a direction of the local frame at p, degrees.
double true_bearing_deg(const LocalFrame& frame, Point p, double heading_rad);

}  // namespace selion
