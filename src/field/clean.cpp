// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "loops.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "tangle.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr double kWidest_m = 0.01;  // a repair may move a border by this
constexpr double kShare = 1e-3;     // and change the area by this share
constexpr double kNothing_m2 = 1e-6;

std::string square_metres(double m2) { return fixed(m2, m2 < 10 ? 2 : 0) + " m2"; }

/// United until nothing more joins: one sweep can leave two areas apart that share an edge.
Polygons joined(const Polygons& areas) {
  Polygons result = unite(areas);
  for (std::size_t before = areas.size() + 1; result.size() < before;) {
    before = result.size();
    result = unite(result);
  }
  return result;
}

/// At most so much lies within `near_m` of the border.
double area_near_border_m2(const Polygon& area, double near_m) {
  std::size_t corners = area.shell.size();
  for (const Ring& hole : area.holes) corners += hole.size();
  return near_m * perimeter_m(area) + static_cast<double>(corners) * std::numbers::pi * near_m * near_m;
}

/// One ring, cut into loops by the side that the ring as a whole has on its left or right.
struct RingLoops {
  std::string name;           ///< ", part 1, ring 2"
  double claimed_m2 = 0;      ///< as OGC counts a valid ring: signed
  std::vector<Loop> forward;  ///< turning as the ring does
  std::vector<Loop> backward;
};

class Cleaner {
 public:
  Cleaner(const Field& field, const LocalFrame& frame, Repair repair)
      : field_{field}, frame_{frame}, repair_{repair} {}

  Cleaned clean() {
    const std::vector<Ring> rings = local_rings();
    std::size_t next = 0;
    double claimed_m2 = 0;
    for (std::size_t part = 0; part < field_.parts.size(); ++part) {
      const RingLoops shell = ring_loops(rings[next++], ring_name(part, 0));
      claimed_m2 += shell.claimed_m2;
      std::vector<RingLoops> holes;
      for (std::size_t hole = 0; hole < field_.parts[part].holes.size(); ++hole) {
        holes.push_back(ring_loops(rings[next++], ring_name(part, hole + 1)));
        claimed_m2 -= holes.back().claimed_m2;
      }
      part_areas_.push_back(part_area(shell, holes));
    }
    check_overlapping_parts();
    Polygons all;
    for (const Polygons& area : part_areas_) all.insert(all.end(), area.begin(), area.end());
    result_.parts = joined(all);
    check_area(claimed_m2);
    note_changed_parts();
    drop_small_parts();
    add_gaps();
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::string ring_name(std::size_t part, std::size_t ring) const {
    return (field_.parts.size() > 1 ? ", part " + std::to_string(part + 1) : "") + ", ring " +
           std::to_string(ring + 1);
  }
  [[nodiscard]] std::string near(Point p) const { return " near " + place(frame_.to_lonlat(p)); }
  void note(const std::string& text) { result_.notes.push_back(field_.source + text); }

  /// An error, or with --repair a note.
  void refuse(const std::string& what, const std::string& advice, const std::string& repaired) {
    if (repair_ == Repair::notes_only)
      throw InputError{field_.source + what + "; " + advice + ", or accept with --repair that " + repaired};
    note(what + "; repaired: " + repaired);
  }

  std::vector<Ring> local_rings() {
    std::vector<Ring> rings;
    for (std::size_t part = 0; part < field_.parts.size(); ++part) {
      rings.push_back(local_ring(field_.parts[part].shell, frame_, field_.source + ring_name(part, 0)));
      for (std::size_t hole = 0; hole < field_.parts[part].holes.size(); ++hole)
        rings.push_back(
            local_ring(field_.parts[part].holes[hole], frame_, field_.source + ring_name(part, hole + 1)));
    }
    if (const int dropped = snap(rings); dropped > 0)
      note(": " + std::to_string(dropped) + " corners closer than 1 mm to another are dropped");
    return rings;
  }

  RingLoops ring_loops(Ring ring, const std::string& name) {
    for (const Spike& spike : drop_spikes(ring))
      note_spike(spike.foot, distance_m(spike.foot, spike.tip), name);
    std::vector<Loop> loops = loops_of(ring);
    const auto size = [](const Loop& loop) { return std::abs(signed_area_m2(loop.ring)); };
    const auto largest = std::max_element(loops.begin(), loops.end(),
                                          [&](const Loop& a, const Loop& b) { return size(a) < size(b); });
    RingLoops result{name, std::abs(signed_area_m2(ring)), {}, {}};
    if (largest == loops.end()) return result;
    const bool anticlockwise = signed_area_m2(largest->ring) > 0;
    for (Loop& loop : loops) {
      if (loops.size() > 1 && is_sliver({{loop.ring, {}}}))
        note_dropped(loop, name);
      else
        ((signed_area_m2(loop.ring) > 0) == anticlockwise ? result.forward : result.backward)
            .push_back(std::move(loop));
    }
    return result;
  }

  void note_dropped(const Loop& loop, const std::string& name) {
    double reach_m = 0;
    for (const Point p : loop.ring) reach_m = std::max(reach_m, distance_m(p, loop.pinch));
    note_spike(loop.pinch, reach_m, name);
  }

  void note_spike(Point foot, double reach_m, const std::string& name) {
    if (reach_m > kWidest_m)
      note(name + ": a spike less than 1 cm wide and " + fixed(reach_m, 2) + " m long is dropped" +
           near(foot));
  }

  static Polygons areas_of(const std::vector<Loop>& loops) {
    Polygons areas;
    for (const Loop& loop : loops) areas.push_back({loop.ring, {}});
    return areas;
  }

  /// What the ring encloses. Backward loops inside it are holes reached by a bridge; outside it they are a
  /// crossing.
  Polygons shell_area(const RingLoops& shell) {
    const Polygons forward = areas_of(shell.forward);
    Polygons filled = unite(forward);
    for (std::size_t i = 1; i < forward.size() && area_m2(forward) - area_m2(filled) > kNothing_m2; ++i) {
      const Polygons earlier(forward.begin(), forward.begin() + static_cast<std::ptrdiff_t>(i));
      if (!is_sliver(intersect({forward[i]}, earlier))) refuse_crossing(shell.name, shell.forward[i].pinch);
    }
    for (const Loop& loop : shell.backward) {
      const Polygons outside = subtract({{loop.ring, {}}}, filled);
      result_.holes.push_back({loop.ring, {}});
      if (is_sliver(outside)) {
        note(shell.name + " touches itself" + near(loop.pinch) + ", and encloses a hole there");
        continue;
      }
      refuse_crossing(shell.name, loop.pinch);
      result_.holes.pop_back();
      const Polygons inside = intersect({{loop.ring, {}}}, filled);
      result_.holes.insert(result_.holes.end(), inside.begin(), inside.end());
      filled.insert(filled.end(), outside.begin(), outside.end());
    }
    filled = unite(filled);
    if (filled.size() > 1 && shell.forward.size() > 1)
      note(shell.name + " touches itself" + near(shell.forward.front().pinch) + ", and is cut there");
    return filled;
  }

  void refuse_crossing(const std::string& ring, Point at) {
    refuse(ring + " crosses itself" + near(at), "correct the boundary there",
           "everything that it encloses is field");
  }

  Polygons part_area(const RingLoops& shell, const std::vector<RingLoops>& holes) {
    const std::size_t bridges_from = result_.holes.size();
    const Polygons filled = shell_area(shell);
    Polygons off(result_.holes.begin() + static_cast<std::ptrdiff_t>(bridges_from), result_.holes.end());
    for (const RingLoops& hole : holes) {
      for (const Loop& loop : hole.backward) refuse_crossing(hole.name, loop.pinch);
      std::vector<Loop> loops = hole.forward;
      loops.insert(loops.end(), hole.backward.begin(), hole.backward.end());
      const Polygons area = unite(areas_of(loops));
      if (loops.size() > 1) note(hole.name + " is a hole that touches itself" + near(loops.front().pinch));
      const Polygons outside = subtract(area, filled);
      const bool inside = is_sliver(outside);
      if (!inside)
        refuse(hole.name + " is a hole, but " + square_metres(area_m2(outside)) +
                   " of it lie outside its part" + near(outside.front().shell.front()),
               "correct the hole", "only what lies inside is taken off");
      if (const Polygons twice = intersect(area, off); !is_sliver(twice))
        refuse(hole.name + " is a hole, and shares " + square_metres(area_m2(twice)) + " with another hole" +
                   near(twice.front().shell.front()),
               "correct the holes", "both are taken off");
      if (inside && !area.empty()) note_notch(area, filled, outside, hole.name);
      off.insert(off.end(), area.begin(), area.end());
      result_.holes.insert(result_.holes.end(), area.begin(), area.end());
    }
    return subtract(filled, off);
  }

  /// Holes that share a stretch of the border come out as notches of it; so do those that reach out a little.
  void note_notch(const Polygons& hole, const Polygons& filled, const Polygons& outside,
                  const std::string& name) {
    constexpr double kReach_m = 2e-3;
    constexpr double kStretch_m2 = 5e-5;  // 2 cm of border; a hole that touches at a point stays a hole
    if (area_m2(subtract(outset_round(hole, kReach_m), filled)) > kStretch_m2)
      note(name + " is a hole on the border" + near(hole.front().shell.front()) +
           ", and is taken off as a notch");
    else if (!outside.empty())
      note(name + " is a hole that reaches out of its part by less than 1 cm" +
           near(outside.front().shell.front()) + ", and is cut there");
  }

  /// Loops and parts that meet all round, be it in points, leave holes between them that no ring gives.
  void add_gaps() {
    constexpr double kCrack_m = 4e-3;  // between parts that are to meet: no machine gets through
    Polygons enclosed;
    for (const Polygon& closed : outset_round(result_.parts, kCrack_m))
      for (const Ring& hole : closed.holes) enclosed.push_back({hole, {}});
    if (enclosed.empty()) return;
    Polygons known = result_.parts;
    known.insert(known.end(), result_.holes.begin(), result_.holes.end());
    for (Polygon& gap : subtract(outset_round(enclosed, kCrack_m), known))
      if (!is_sliver({gap})) result_.holes.push_back(std::move(gap));
  }

  void check_overlapping_parts() {
    std::vector<std::pair<Box, const Polygon*>> earlier;
    for (std::size_t part = 0; part < part_areas_.size(); ++part) {
      const std::size_t before = earlier.size();
      Polygons near;  // of the earlier ones
      for (const Polygon& area : part_areas_[part]) {
        const Box box = bounds(area.shell);
        for (std::size_t i = 0; i < before; ++i)
          if (meet(box, earlier[i].first)) near.push_back(*earlier[i].second);
        earlier.emplace_back(box, &area);
      }
      if (near.empty()) continue;
      if (const Polygons twice = intersect(part_areas_[part], near); !is_sliver(twice))
        refuse(", part " + std::to_string(part + 1) + " shares " + square_metres(area_m2(twice)) +
                   " with an earlier part" + this->near(twice.front().shell.front()),
               "correct the parts", "they are united");
    }
  }

  void check_area(double claimed_m2) {
    if (is_sliver(result_.parts))
      throw InputError{field_.source +
                       " has zero area: nothing of it is wider than 1 cm, or its holes leave nothing; "
                       "correct the boundary"};
    const double left_m2 = area_m2(result_.parts);
    if (std::abs(left_m2 - claimed_m2) <= kShare * claimed_m2 + kNothing_m2) return;
    refuse(": cleaning changes its area from " + square_metres(claimed_m2) + " to " + square_metres(left_m2),
           "correct its rings", "the area changes");
  }

  void note_changed_parts() {
    std::size_t before = 0;
    for (const Polygons& area : part_areas_) before += area.size();
    if (result_.parts.size() < before)
      note(": " + std::to_string(before) + " parts that touch along their borders are joined to " +
           std::to_string(result_.parts.size()));
  }

  void drop_small_parts() {
    constexpr double kSmallest_m2 = 1;
    Polygons kept;
    for (Polygon& area :
         result_.parts) {  // largest first: a lone small one is kept, for the planner to judge
      if (!is_sliver({area}) && (kept.empty() || area_m2(area) >= kSmallest_m2))
        kept.push_back(std::move(area));
      else
        note(": a part of " + square_metres(area_m2(area)) + " is dropped" + near(area.shell.front()));
    }
    result_.parts = std::move(kept);
  }

  const Field& field_;
  const LocalFrame& frame_;
  Repair repair_;
  std::vector<Polygons> part_areas_;
  Cleaned result_;
};

}  // namespace

/// More area than lies within half the width of sides and corners is somewhere wider: most need no inset.
bool is_sliver(const Polygons& areas) {
  constexpr double kHalf_m = kWidest_m / 2;
  double near_m2 = 0;
  for (const Polygon& area : areas) near_m2 += area_near_border_m2(area, kHalf_m);
  if (area_m2(areas) > 2 * near_m2) return false;
  return areas.empty() || inset(areas, kHalf_m).empty();
}

Ring local_ring(const LonLatRing& ring, const LocalFrame& frame, const std::string& where) {
  constexpr double kFarthest_m = 100e3;
  Ring local;
  local.reserve(ring.size());
  for (const LonLat p : ring) {
    local.push_back(frame.to_local(p));
    if (!(distance_m(local.back(), local.front()) < kFarthest_m))
      throw InputError{where + ": " + place(p) + " is more than 100 km from " + place(ring.front()) +
                       "; this is no field: correct the coordinates"};
  }
  refuse_tangle(local, frame, where);
  return local;
}

Cleaned cleaned(const Field& field, const LocalFrame& frame, Repair repair) {
  return Cleaner{field, frame, repair}.clean();
}

}  // namespace selion
