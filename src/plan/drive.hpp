// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/motion/speed.hpp"
#include "selion/route/route.hpp"

namespace selion {

/// One leg a stretch, with its speed cap, and waits for the tool.
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

/// The tool is down from the start of a swath or headland pass to its end, at the joints of legs. It rises
/// while the machine drives on and is up before the machine reverses or pivots. It comes down on the run-in,
/// driven so slowly that tool_lower_s pass there; where there is none, or it would have to creep, the machine
/// stands at the start of the work until the tool is down. Where curvature jumps at a change of gear it
/// stands while the wheels are steered.
Drive drive_of(const Route& route, const Machine& machine);

}  // namespace selion
