// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "clean.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/geometry/boolean.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr double kSmallest_m2 = 1;

/// A piece of a field: to be covered, and free of obstacles with their clearance.
struct Piece {
  Polygon area;
  Polygon free;
};

Polygons local_area(const Obstacle& obstacle, const LocalFrame& frame, const std::string& where) {
  const std::string name = where + ", obstacle '" + obstacle.name + "'";
  Polygon area{local_ring(obstacle.area.shell, frame, name), {}};
  for (const LonLatRing& hole : obstacle.area.holes) area.holes.push_back(local_ring(hole, frame, name));
  return unite({area});
}

void append(Polygons& to, const Polygons& more) { to.insert(to.end(), more.begin(), more.end()); }

/// What no machine may touch.
struct Kept {
  std::vector<BlockObstacle> obstacles;
  Polygons off;    ///< they together: not to be covered
  Polygons grown;  ///< holes and obstacles with their clearance
};

Kept kept_clear(const Field& field, const LocalFrame& frame, const Polygons& holes,
                const BlockOptions& options) {
  Polygons plain = holes;
  Polygons water;
  Kept kept;
  for (const Obstacle& obstacle : field.obstacles) {
    const Polygons area = local_area(obstacle, frame, field.source);
    append(obstacle.kind == ObstacleKind::water ? water : plain, area);
    append(kept.off, area);
    for (const Polygon& part : area) kept.obstacles.push_back({obstacle.name, obstacle.kind, part});
  }
  kept.grown = outset_round(plain, options.obstacle_clearance_m);
  append(kept.grown, outset_round(water, options.water_margin_m));
  return kept;
}

/// The pieces of `areas` worth planning, tidied.
Polygons worthwhile(const Polygons& areas) {
  Polygons kept;
  for (const Polygon& area : areas)
    if (Polygon tidy = tidied(area);
        !tidy.shell.empty() && !is_sliver({tidy}) && (kept.empty() || area_m2(tidy) >= kSmallest_m2))
      kept.push_back(std::move(tidy));
  return kept;
}

/// The part of `areas` that holds most of `piece`.
Polygon around(const Polygon& piece, const Polygons& areas) {
  const Polygon* most = &piece;
  double most_m2 = 0;
  for (const Polygon& area : areas)
    if (const double shared_m2 = area_m2(intersect({area}, {piece})); shared_m2 > most_m2)
      most = &area, most_m2 = shared_m2;
  return *most;
}

/// Free pieces grown in step with each other over the ground beside the obstacles, until they meet.
Polygons grown_together(const Polygon& area, const Polygons& free, double reach_m) {
  constexpr int kSteps = 12;
  Polygons grown = free;
  for (int step = 0; step < kSteps; ++step)
    for (std::size_t i = 0; i < grown.size(); ++i) {
      Polygons others = grown;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      const Polygons wider = outset({grown[i]}, reach_m / kSteps, 2);
      grown[i] = around(free[i], intersect(wider, subtract({area}, others)));
    }
  return grown;
}

/// Shares `area` out to the pieces of its free space, all within `reach_m` of one; what lies further goes to
/// the first that it touches.
std::vector<Piece> shared_out(const Polygon& area, const Polygons& free, double reach_m) {
  Polygons shares = grown_together(area, free, reach_m);
  for (const Polygon& left : subtract({area}, shares)) {
    for (Polygon& share : shares) {
      Polygons joined = unite({share, left});
      if (joined.size() != 1) continue;
      share = std::move(joined.front());
      break;
    }
  }
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < free.size(); ++i)
    if (Polygon tidy = tidied(shares[i]); !tidy.shell.empty()) pieces.push_back({std::move(tidy), free[i]});
  return pieces;
}

std::string hectares(double m2) { return fixed(m2 / 1e4, 4) + " ha"; }

/// What `area` becomes once its obstacles have their clearance: nothing, itself, or several pieces.
std::vector<Piece> pieces_of(const Polygon& area, const Kept& kept, double reach_m, const std::string& where,
                             std::vector<std::string>& notes) {
  const Polygons free = worthwhile(subtract({area}, kept.grown));
  if (free.size() == 1) return {{area, free.front()}};
  const std::string part = "a part of " + hectares(area_m2(area)) + where;
  if (free.empty()) {
    notes.push_back(part + " is left out: obstacles and their clearance fill it");
    return {};
  }
  notes.push_back("obstacles with their clearance cut " + part + " into " + std::to_string(free.size()) +
                  " blocks");
  return shared_out(area, free, reach_m);
}

std::vector<BlockObstacle> obstacles_beside(const Polygon& area, const Kept& kept, double reach_m) {
  std::vector<BlockObstacle> beside;
  for (const BlockObstacle& obstacle : kept.obstacles) {
    if (intersect(outset_round({obstacle.area}, reach_m), {area}).empty()) continue;
    Polygon tidy = tidied(obstacle.area);
    if (!tidy.shell.empty()) beside.push_back({obstacle.name, obstacle.kind, std::move(tidy)});
  }
  return beside;
}

}  // namespace

Blocks blocks_of(const Field& field, const LocalFrame& frame, const BlockOptions& options) {
  const Cleaned clean = cleaned(field, frame, options.repair);
  // a part may lie in another one's hole
  const Kept kept = kept_clear(field, frame, subtract(clean.holes, clean.parts), options);
  const double reach_m =
      std::max(options.obstacle_clearance_m, options.water_margin_m) * 1.5 + 0.01;  // around corners too
  std::vector<std::string> notes;
  std::vector<Piece> pieces;
  for (const Polygon& area : worthwhile(subtract(clean.parts, kept.off))) {
    const std::string where = " near " + place(frame.to_lonlat(area.shell.front()));
    for (Piece& piece : pieces_of(area, kept, reach_m, where, notes)) pieces.push_back(std::move(piece));
  }
  if (pieces.empty())
    throw InputError{field.source +
                     " has no area left beside its obstacles and their clearance; correct the obstacles, or "
                     "lower the clearance"};
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return area_m2(a.area) > area_m2(b.area); });
  Blocks result{{}, clean.notes};
  for (const std::string& note : notes) result.notes.push_back(field.source + ": " + note);
  for (Piece& piece : pieces) {
    Block block;
    block.number = static_cast<int>(result.blocks.size()) + 1;
    block.obstacles = obstacles_beside(piece.area, kept, reach_m);
    block.area = std::move(piece.area);
    block.free = std::move(piece.free);
    result.blocks.push_back(std::move(block));
  }
  attach_gates(field, frame, result);
  return result;
}

}  // namespace selion
