// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "selion/core/machine.hpp"
#include "selion/core/progress.hpp"
#include "selion/field/block.hpp"
#include "selion/layout/layout.hpp"
#include "selion/motion/path.hpp"

namespace selion {

enum class PieceKind { swath, headland_pass, turn, transfer };

/// One leg of the drive: a swath or headland pass with the tool down, or the way to the next one with the
/// tool up.
struct RoutePiece {
  PieceKind kind = PieceKind::swath;
  std::string ref;  ///< id of what is worked; empty between
  Path path;

  friend bool operator==(const RoutePiece&, const RoutePiece&) = default;
};

/// Everything that one machine drives in one block, end to end without a gap.
struct Route {
  std::vector<RoutePiece> pieces;
  std::vector<std::string> left_out;  ///< ids of what the machine cannot reach, or not leave again
  std::vector<std::string> notes;
  std::vector<std::string> warnings;  ///< what a person must know before driving it

  friend bool operator==(const Route&, const Route&) = default;
};

enum class HeadlandOrder { first, last, none };  ///< when the headland is worked

/// What routes have found out about the ground of one block with one machine: which ways stay inside.
struct KnownGround;
std::shared_ptr<KnownGround> nothing_known();

struct RouteOptions {
  HeadlandOrder headland = HeadlandOrder::last;
  std::optional<std::size_t> gate;  ///< of the block's gates: where the drive starts and ends; absent: free
  std::shared_ptr<KnownGround> known = nothing_known();  ///< by routes over other layouts of the block; grows
};

/// Visits every swath piece, pocket piece and headland pass once: swaths in adjacent order, back and forth,
/// chain by chain where holes and bays split them, then pockets; the headland from the inside out (last) or
/// the outside in (first). What cannot be reached is left out and named. Infeasible where not a single swath
/// can be driven, or the machine does not pass the gate.
Result<Route> route(const Block& block, const Layout& layout, const Machine& machine,
                    const RouteOptions& options, const Progress& progress);

}  // namespace selion
