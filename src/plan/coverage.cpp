// SPDX-License-Identifier: GPL-3.0-or-later
#include "coverage.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "selion/motion/footprint.hpp"

namespace selion {
namespace {

/// Narrower than a centimetre on average: rounding between sweeps, not unworked ground.
bool is_gap(const Polygon& part) {
  constexpr double kHalf_m = 0.005;
  return area_m2(part) < kHalf_m * perimeter_m(part);
}

/// The areas of some pieces: each step of the tool for itself, summed, and all together.
struct Swept {
  double sum_m2 = 0;
  Polygons together;
};

class Tally {
 public:
  explicit Tally(double turned_rad) : turned_rad_{turned_rad} {}

  /// What the tool sweeps on the path: where it comes over its own ground again, that counts again.
  void add(const Footprint& footprint, const Path& path) {
    for (Ring& ring : swept_by_tool(footprint, path)) {
      swept_.sum_m2 += signed_area_m2(ring);
      all_.push_back({std::move(ring), {}});
    }
  }
  Swept united() && {
    swept_.together = unite(turned(std::move(all_), turned_rad_));
    return std::move(swept_);
  }

 private:
  double turned_rad_;
  Swept swept_;
  Polygons all_;
};

Polygons joined(const Polygons& a, const Polygons& b) {
  Polygons both = a;
  both.insert(both.end(), b.begin(), b.end());
  return unite(both);
}

}  // namespace

Coverage coverage_of(const Block& block, const Layout& layout, const Route& route, const Machine& machine) {
  const Footprint footprint = footprint_of(machine);
  std::set<std::string> pocket_ids;
  for (const Swath& pocket : layout.pockets) pocket_ids.insert(pocket.id);
  const double flat_rad = -layout.along.radians();  // with the swaths from west to east
  Tally headland_tally{flat_rad};
  Tally swath_tally{flat_rad};
  Tally pocket_tally{flat_rad};
  for (const RoutePiece& piece : route.pieces) {
    if (piece.kind == PieceKind::headland_pass)
      headland_tally.add(footprint, piece.path);
    else if (piece.kind == PieceKind::swath)
      (pocket_ids.contains(piece.ref) ? pocket_tally : swath_tally).add(footprint, piece.path);
  }
  const Swept headland = std::move(headland_tally).united();
  const Swept swaths = std::move(swath_tally).united();
  const Swept pockets = std::move(pocket_tally).united();
  const Polygons main = joined(headland.together, swaths.together);
  const Polygons all = pockets.together.empty() ? main : joined(main, pockets.together);
  Polygons left = subtract(turned({block.area}, flat_rad), all);

  Coverage coverage;
  coverage.covered_m2 = area_m2(block.area) - area_m2(left);
  coverage.twice.corners_m2 = headland.sum_m2 - area_m2(headland.together);
  coverage.twice.last_strip_m2 = swaths.sum_m2 - area_m2(swaths.together);
  coverage.twice.wedges_m2 = area_m2(headland.together) + area_m2(swaths.together) - area_m2(main);
  coverage.twice.pockets_m2 = pockets.sum_m2 - (area_m2(all) - area_m2(main));
  std::erase_if(left, is_gap);
  coverage.uncovered = turned(std::move(left), -flat_rad);
  return coverage;
}

Coverage coverage_of_all(const Block& block, const Layout& layout, const Machine& machine) {
  Route all;
  for (const HeadlandPass& pass : layout.headland_passes) {
    all.pieces.push_back({PieceKind::headland_pass, pass.id, pass.path});
    for (const HeadlandPart& part : pass.parts)
      all.pieces.push_back({PieceKind::headland_pass, pass.id, part.path});
  }
  for (const auto* swaths : {&layout.swaths, &layout.pockets})
    for (const Swath& swath : *swaths)
      all.pieces.push_back({PieceKind::swath, swath.id, swath_path(machine, swath.from, swath.to)});
  return coverage_of(block, layout, all, machine);
}

}  // namespace selion
