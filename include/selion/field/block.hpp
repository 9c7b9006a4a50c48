// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "selion/field/field.hpp"
#include "selion/field/frame.hpp"
#include "selion/geometry/polygon.hpp"

namespace selion {

enum class Repair { notes_only, accept };  ///< accept: also repairs that move a boundary by more than 1 cm

struct BlockOptions {
  double obstacle_clearance_m = 0.5;
  double water_margin_m = 3;
  Repair repair = Repair::notes_only;
};

/// A gate snapped to a block's border.
struct BlockGate {
  std::string name;
  Point at;               ///< on the border
  double inward_rad = 0;  ///< heading into the block, across the border
  std::optional<double> width_m;
  int number = 1;  ///< among all gates of the field, block by block

  friend bool operator==(const BlockGate&, const BlockGate&) = default;
};

/// A hole that was given as an obstacle, as it is in the file.
struct BlockObstacle {
  std::string name;
  ObstacleKind kind = ObstacleKind::obstacle;
  Polygon area;

  friend bool operator==(const BlockObstacle&, const BlockObstacle&) = default;
};

/// One cleaned part of a field, in local metres.
struct Block {
  int number = 1;  ///< of the field's blocks, from 1
  Polygon area;    ///< the part as cleaned, its own holes and all obstacles taken off: what is to be covered
  Polygon free;    ///< `area` with every hole grown by its clearance: where body and tool may be
  std::vector<BlockObstacle> obstacles;  ///< that border on it or lie in it
  std::vector<BlockGate> gates;

  friend bool operator==(const Block&, const Block&) = default;
};

struct Blocks {
  std::vector<Block> blocks;       ///< largest first
  std::vector<std::string> notes;  ///< each repair and each gate or part left out, with place and size

  friend bool operator==(const Blocks&, const Blocks&) = default;
};

/// The field's parts cleaned: closed, deduplicated, spikes removed, holes and obstacles subtracted,
/// overlapping parts united. A repair that moves no boundary by more than 1 cm and changes the area by at
/// most 0.1 % becomes a note.
/// @throws InputError for any larger one (naming feature, part, ring and lon/lat, and `--repair`), for zero
/// area, and for coordinates too far apart to be one field.
Blocks blocks_of(const Field& field, const LocalFrame& frame, const BlockOptions& options);

}  // namespace selion
