// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "corner_ways.hpp"
#include "parts.hpp"
#include "ring_legs.hpp"
#include "swept_ground.hpp"

namespace selion {
namespace {

// In squares of the working width w. Rounding with radius R leaves (R/w + 1/2)^2 (tan(turn/2) - turn/2) of a
// corner: at a right angle a quarter of a square and more, at 60 degrees about a tenth, along a curve next to
// nothing.
constexpr double kWorth = 0.15;       // found in a corner that is filled
constexpr double kPiece = 0.03;       // found by a piece that is driven or worked for it besides
constexpr double kScrap = 0.01;       // too little to drive on for
constexpr double kLeastShare = 0.15;  // of what is driven back along a bend wider than a corner's, unworked
constexpr double kLeastSide = 0.5;    // of the working width: shorter ones are parts of bends
constexpr double kSliver_m = 0.1;     // gaps narrower than twice this are guidance error

double sum_m2(const Polygons& areas) {
  double sum = 0;
  for (const Polygon& area : areas) sum += area_m2(area);
  return sum;
}

/// Fills corner after corner, and keeps account of the ground.
class Filler {
 public:
  Filler(const Ground& ground, const Layout& layout)
      : ground_{ground},
        square_m2_{ground.machine.working_width_m * ground.machine.working_width_m},
        left_{unworked(ground, layout, {})},
        swept_{ground.footprint} {
    for (const Swath& swath : layout.swaths)
      swept_.add(swath_path(ground.machine, swath.from, swath.to), kOthers);
    for (const HeadlandPass& pass : layout.headland_passes) rings_.push_back(ring_of(pass));
  }

  /// Of the layout's pass `index`; none where no corner of it is worth it.
  std::vector<HeadlandPart> parts_of(std::size_t index) {
    const RingLegs& ring = rings_[index];
    std::vector<std::optional<Fill>> fills;
    for (std::size_t i = 0; i < ring.legs.size(); ++i) fills.push_back(fill_after(ring, i));
    const auto is_filled = [](const std::optional<Fill>& fill) { return fill.has_value(); };
    if (std::none_of(fills.begin(), fills.end(), is_filled)) return {};
    return cut(ring.legs, fills);
  }

 private:
  static constexpr std::size_t kOthers = 0;
  struct RingLegs {
    std::vector<RingLeg> legs;
    std::size_t first_bend = 0;  ///< whose the first bend's strips are; of the next ones the next
  };
  /// What a straight piece finds unworked, and how far it has to go for that.
  struct Find {
    Polygons ground;
    double by_m = 0;
  };

  RingLegs ring_of(const HeadlandPass& pass) {
    RingLegs ring{pass.closed ? legs_of(pass.path, kLeastSide * ground_.machine.working_width_m)
                              : std::vector<RingLeg>{},
                  bends_};
    if (ring.legs.empty()) swept_.add(pass.path, kOthers);
    for (const RingLeg& leg : ring.legs) {
      swept_.add({leg.side}, kOthers);
      swept_.add(leg.bend, bends_++);
    }
    return ring;
  }

  /// What of `ground` is worth a piece.
  [[nodiscard]] Polygons without_slivers(const Polygons& ground) const {
    Polygons parts = outset_round(inset_round(ground, kSliver_m), kSliver_m);
    std::erase_if(parts, [&](const Polygon& part) { return area_m2(part) < kScrap * square_m2_; });
    return parts;
  }

  [[nodiscard]] Polygons found_by(const Path& path) const {
    return intersect(left_, swept_by(ground_.footprint, path));
  }

  [[nodiscard]] Find find_back(const LeftTurn& turn) const {
    const double most_m = farthest_back_m(ground_, turn);
    Find find{without_slivers(found_by(straight(on_from(turn.out, -most_m), most_m))), 0};
    const Point axis = unit(turn.out.heading_rad);
    const double tool_m = dot(turn.out.at, axis) + ground_.machine.tool_x_m;
    if (!find.ground.empty())
      find.by_m = std::min(most_m, tool_m - extent_of(find.ground, axis).low_m + kSliver_m);
    return find;
  }

  /// But for what the next side finds.
  [[nodiscard]] Find find_on(const LeftTurn& turn, const Polygons& but) const {
    const double most_m = farthest_on_m(ground_, turn);
    Find find{without_slivers(subtract(found_by(straight(turn.in, most_m)), but)), 0};
    const Point axis = unit(turn.in.heading_rad);
    const double tool_m = dot(turn.in.at, axis) + ground_.machine.tool_x_m;
    if (!find.ground.empty())
      find.by_m = std::min(most_m, extent_of(find.ground, axis).high_m - tool_m + kSliver_m);
    return find;
  }

  [[nodiscard]] Polygons swept_straight(const LeftTurn& turn, const Fill& fill) const {
    Polygons swept = swept_by(ground_.footprint, straight(turn.in, fill.on_m));
    for (Polygon& part : swept_by(ground_.footprint, straight(on_from(turn.out, -fill.back_m), fill.back_m)))
      swept.push_back(std::move(part));
    return swept;
  }

  /// What only the bend works, once the corner is filled.
  [[nodiscard]] double only_bend_m2(const LeftTurn& turn, const Fill& fill, std::size_t bend) const {
    return sum_m2(subtract(swept_.swept_only_by(bend, ground_.workable), swept_straight(turn, fill)));
  }

  /// Absent where it is not worth it. One that only drives forwards does not come back for the bend.
  [[nodiscard]] std::optional<Fill> worthwhile(const LeftTurn& turn, std::size_t bend) const {
    const Find back = find_back(turn);
    if (back.ground.empty()) return std::nullopt;
    const double share = sum_m2(back.ground) / (ground_.machine.working_width_m * back.by_m);
    if (share < kLeastShare && !is_corner(ground_, turn)) return std::nullopt;
    const Find on = find_on(turn, back.ground);
    Fill fill{on.by_m, back.by_m};
    double gained_m2 = sum_m2(back.ground) + sum_m2(on.ground);
    const double only_bend = only_bend_m2(turn, fill, bend);
    fill.round = ground_.machine.may_reverse && only_bend >= kPiece * square_m2_;
    if (!fill.round) {
      gained_m2 -= only_bend;
    } else if (sum_m2(on.ground) < kPiece * square_m2_) {
      fill.on_m = 0;
      gained_m2 -= sum_m2(on.ground);
    }
    return gained_m2 >= kWorth * square_m2_ ? std::optional{fill} : std::nullopt;
  }

  std::optional<Fill> fill_after(const RingLegs& ring, std::size_t i) {
    const RingLeg& leg = ring.legs[i];
    const auto turn = left_turn(leg.bend);
    if (!turn || turn->before_m < 0 || turn->after_m < 0) return std::nullopt;
    const std::size_t bend = ring.first_bend + i;
    auto fill = worthwhile(*turn, bend);
    if (!fill) return std::nullopt;
    if (!fill->round) {
      const RingLeg& next = ring.legs[(i + 1) % ring.legs.size()];
      auto way =
          way_round(ground_, *turn, leg.bend, *fill, {leg.side.curve.length_m, next.side.curve.length_m});
      if (!way) return std::nullopt;
      fill->way = std::move(*way);
      swept_.remove(bend);
    }
    keep(swept_straight(*turn, *fill));
    return fill;
  }

  void keep(Polygons swept) {
    left_ = subtract(left_, swept);
    for (Polygon& part : swept) swept_.add(std::move(part.shell), kOthers);
  }

  const Ground& ground_;
  double square_m2_;
  Polygons left_;
  SweptGround swept_;
  std::vector<RingLegs> rings_;
  std::size_t bends_ = kOthers + 1;
};

}  // namespace

void fill_corners(const Ground& ground, Layout& layout) {
  Filler filler{ground, layout};
  for (std::size_t i = 0; i < layout.headland_passes.size(); ++i)
    layout.headland_passes[i].parts = filler.parts_of(i);
}

}  // namespace selion
