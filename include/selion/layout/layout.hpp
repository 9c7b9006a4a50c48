// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "selion/core/error.hpp"
#include "selion/core/machine.hpp"
#include "selion/field/block.hpp"
#include "selion/geometry/boolean.hpp"
#include "selion/layout/direction.hpp"
#include "selion/motion/path.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// Of a ring cut at its corners: worked from one to the next.
struct HeadlandPart {
  Path path;
  Path way_on;  ///< tool up, to where the next part begins; the first one follows the last

  friend bool operator==(const HeadlandPart&, const HeadlandPart&) = default;
};

/// One drive around the border or an obstacle, or a part of one, tool down: the axle's path.
struct HeadlandPass {
  std::string id;  ///< "H1", "H2", ...
  int ring = 1;    ///< 1 is outermost (nearest to border or obstacle)
  Path path;
  bool closed = true;                 ///< ends where it begins; may then be begun anywhere
  std::vector<HeadlandPart> parts{};  ///< of a ring with filled corners: worked instead of `path`
  bool either_way = false;            ///< the machine fits on `path` driven the other way, too

  friend bool operator==(const HeadlandPass&, const HeadlandPass&) = default;
};

/// One straight pass of the tool: its centre line from the A side to the B side (the tool's, not the axle's).
struct Swath {
  std::string id;  ///< "12", "12b"; pocket pieces "P3"
  int strip = 0;   ///< number across the field, from 1; 0 for a pocket piece
  Point from;
  Point to;

  friend bool operator==(const Swath&, const Swath&) = default;
};

/// The line that the swaths are parallel to, from A to B.
struct AbLine {
  Point a;
  Point b;

  friend bool operator==(const AbLine&, const AbLine&) = default;
};

/// Where tool and axle run in one block.
struct Layout {
  DrivingDirection along;
  AbLine ab;  ///< swath 1's line, or the one given; without swaths a line along the block
  int passes = 0;
  double headland_depth_m = 0;                ///< from the border to where the swaths' area begins
  double turn_depth_m = 0;                    ///< what the machine's own U-turn between neighbours needs
  Polygons headland;                          ///< the band
  Polygons mainland;                          ///< what the swaths must cover; may be nothing
  std::vector<HeadlandPass> headland_passes;  ///< outermost first
  std::vector<Swath> swaths;                  ///< in strip order, pieces along A -> B
  std::vector<Swath> pockets;                 ///< straight pieces for what the above leave
  std::vector<std::string> notes;

  friend bool operator==(const Layout&, const Layout&) = default;
};

/// What lies inside the headland. Ground that is hardly wider than the machine, and bends, is worked along
/// its borders alone.
enum class Interior { swaths, nothing };

/// How headland passes go round left turns: with the tool down, or with the ground in the corner worked.
enum class HeadlandCorners { round, fill };

struct LayoutOptions {
  DrivingDirection along;
  std::optional<AbLine> ab;           ///< fixes heading and phase
  std::optional<double> heading_rad;  ///< of A -> B, where one was asked for; parallel to `along`
  double ab_shift_m = 0;
  double overlap_m = 0;
  double edge_margin_m = 0.3;
  double border_room_m = 0;   ///< the outermost headland passes keep so much further off the border
  std::optional<int> passes;  ///< absent: as many as turns need
  HeadlandCorners corners = HeadlandCorners::round;
  Interior interior = Interior::swaths;  ///< where nothing: as many passes as there is ground for

  friend bool operator==(const LayoutOptions&, const LayoutOptions&) = default;
};

/// How many headland passes it takes for a U-turn to stay inside.
int passes_for_turns(const Block& block, const Machine& machine, const LayoutOptions& options);

/// Of the axle while the tool works from `from` to `to`: the axle runs ahead by the tool's place behind it.
Path swath_path(const Machine& machine, Point from, Point to);

using LayOut = Result<Layout> (*)(const Block&, const Machine&, const LayoutOptions&);

struct LayoutKind {
  std::string_view name;
  std::string_view about;
  LayOut lay_out;
};

/// Every kind of layout, the default first.
std::span<const LayoutKind> layouts();

}  // namespace selion
