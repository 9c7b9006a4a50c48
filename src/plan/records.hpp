// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/field/block.hpp"
#include "selion/field/frame.hpp"
#include "selion/layout/layout.hpp"
#include "selion/motion/speed.hpp"
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
};

/// One leg a stretch, with its speed cap, and waits where the tool takes time to come down or up.
struct DrivePiece {
  Leg leg;
  std::string kind;
  std::string ref;
};

/// A route timed: its legs in order, and where the machine is when.
struct Drive {
  std::vector<DrivePiece> pieces;
  std::vector<Sample> samples;
};
Drive drive_of(const Route& route, const Machine& machine);

LonLatArea to_lonlat(const LocalFrame& frame, const Polygon& area);

/// Adds all records of the block to the file.
void add_records(PlanFile& file, const PlannedBlock& planned, const Drive& drive, const LocalFrame& frame,
                 const Machine& machine);

/// True bearing of a direction of the local frame at p, degrees.
double true_bearing_deg(const LocalFrame& frame, Point p, double heading_rad);

}  // namespace selion
