// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "connect.hpp"
#include "selion/field/block.hpp"

namespace selion {

enum class GateWay { in, out };

/// The machine just inside a gate.
struct AtGate {
  Pose pose;
  double askew_rad = 0;     ///< off square to the border
  double further_in_m = 0;  ///< than where body and tool are just inside

  [[nodiscard]] bool is_square() const { return askew_rad == 0 && further_in_m == 0; }
};

/// Square to the border with body and tool just inside, where the machine fits there; else, as beside a
/// corner, as little further in and as little askew as it takes. Absent where it fits nowhere near.
std::optional<AtGate> at_gate(const Terrain& terrain, const BlockGate& gate, GateWay way);

/// "the gate", or by its name.
std::string called(const BlockGate& gate);

}  // namespace selion
