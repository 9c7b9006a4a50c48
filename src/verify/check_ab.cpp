// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kLine_m = 0.02;
constexpr double kRounded_m = 3e-4;  // of a line's ends by the file's decimals
constexpr double kAngle_deg = 1e-4;  // of a bearing
constexpr double kAsked_deg = 0.05;  // a block asks for its bearing in its middle, north leans elsewhere
constexpr double kDegree = std::numbers::pi / 180;

/// By the ellipsoid: true bearing of a direction at a place.
double bearing_deg(const Plane& plane, Point at, Point ahead) {
  const Point ground = ground_m(plane.to_lonlat(at), plane.to_lonlat(at + ahead));
  return std::atan2(ground.x_m, ground.y_m) / kDegree;
}

double turned_deg(double a, double b, double round) { return std::abs(std::remainder(a - b, round)); }

/// The AB line of a block, what is parallel to it and how far apart.
class AbCheck {
 public:
  AbCheck(Case& plan, const AbRecord& ab)
      : plan_{plan},
        ab_{ab},
        a_{plan.plane.to_local(ab.a)},
        way_{plan.plane.to_local(ab.b) - a_},
        length_m_{distance_m({}, way_)},
        ahead_{unit(heading_rad(longest_way()))} {}

  void run() {
    if (const double askew = std::abs(cross(ahead_, way_)); !(askew <= kLine_m && dot(ahead_, way_) > 0))
      say("ab", a_, {askew, kLine_m},
          "the AB line does not run as the longest swath does: " + shown(askew, 3) + " m askew");
    const double points = bearing_deg(plan_.plane, a_, ahead_);
    bearing("the AB line", ab_.bearing_deg, points, 360);
    for (const CellRecord& cell : plan_.plan.cells)
      if (cell.block == ab_.block) bearing("cell " + cell.id, cell.bearing_deg, points, 180);
    as_asked();
    std::map<int, double> strips;
    for (const SwathRecord& swath : plan_.plan.swaths)
      if (swath.block == ab_.block) swath_on(swath, strips);
    spacing(strips);
  }

 private:
  void say(const char* code, Point at, Measured measured, const std::string& what) {
    plan_.findings.add(code, ab_.block, at, measured, what);
  }

  /// From A to B, or of a longer swath: over a large field a short line's decimals tell too little.
  [[nodiscard]] Point longest_way() const {
    Point longest = way_;
    for (const SwathRecord& swath : plan_.plan.swaths) {
      if (swath.block != ab_.block || !strip_of(swath.id)) continue;
      const Point way = plan_.plane.to_local(swath.line.back()) - plan_.plane.to_local(swath.line.front());
      if (distance_m({}, way) > distance_m({}, longest)) longest = way;
    }
    return longest;
  }

  /// Passes alone have no direction.
  [[nodiscard]] bool has_strips() const {
    return std::ranges::any_of(plan_.plan.swaths, [this](const SwathRecord& swath) {
      return swath.block == ab_.block && strip_of(swath.id).has_value();
    });
  }

  [[nodiscard]] double rounding_deg() const {
    return std::atan(kRounded_m / std::max(length_m_, kRounded_m)) / kDegree;
  }

  void bearing(const std::string& name, double told, double found, double round) {
    const double slack = kAngle_deg + rounding_deg();
    if (turned_deg(told, found, round) <= slack) return;
    say("ab", a_, {told, std::fmod(found + 360, round)},
        name + " is said to bear " + shown(told, 4) + " degrees; the AB line bears " +
            shown(std::fmod(found + 360, round), 4));
  }

  /// As the job has the line, or the bearing.
  void as_asked() {
    const Work& work = plan_.vehicle.work;
    if (!work.ab.empty()) {
      const double off = std::max(
          distance_m(a_, plan_.plane.to_local(LonLat{work.ab[0], work.ab[1]})),
          distance_m(plan_.plane.to_local(ab_.b), plan_.plane.to_local(LonLat{work.ab[2], work.ab[3]})));
      if (!(off <= kLine_m))
        say("ab", a_, {off, kLine_m},
            "the AB line lies " + shown(off, 2) + " m off the one that the job gives");
    } else if (const auto middle = place_in(plan_.ground(ab_.block)->area); work.direction_deg && middle) {
      const double points = bearing_deg(plan_.plane, *middle, ahead_);
      if (!(turned_deg(points, *work.direction_deg, 360) <= kAsked_deg))
        say("ab", a_, {points, *work.direction_deg},
            "the AB line bears " + shown(points, 2) + " degrees, the job asks for " +
                shown(*work.direction_deg, 2));
    } else if (work.by_p3 && has_strips()) {
      by_p3();
    }
  }

  /// The rule of Cariou et al. 2020 turns the field by whole degrees, and knows no holes.
  void by_p3() {
    const double turned = heading_rad(ahead_) / kDegree;
    const double off = turned_deg(turned, 0, 1);
    if (const double slack = kAngle_deg + rounding_deg(); !(off <= slack))
      say("ab", a_, {off, slack}, "the AB line is not turned by whole degrees, as the job's rule p3 has it");
    const bool holes = std::ranges::any_of(outlines_of(plan_.ground(ab_.block)->area),
                                           [](const Outline& outline) { return !outline.holes.empty(); });
    if (holes) say("job", a_, {}, "the job's rule p3 for directions knows no holes; the block has some");
  }

  /// Of a swath of the plan's cell: parallel, from the A side to the B side.
  void swath_on(const SwathRecord& swath, std::map<int, double>& strips) {
    const auto strip = strip_of(swath.id);
    const bool cell = std::ranges::any_of(
        plan_.plan.cells, [&](const CellRecord& c) { return c.block == swath.block && c.id == swath.cell; });
    const Point from = plan_.plane.to_local(swath.line.front());
    const Point to = plan_.plane.to_local(swath.line.back());
    if (strip ? !cell : !swath.cell.empty())
      say("cell", from, {},
          "swath " + swath.id + " is said to be of the cell \"" + swath.cell + "\"" +
              (strip ? ", which the plan does not have" : "; pockets are of none"));
    if (!strip) return;
    const double askew = std::abs(cross(ahead_, to - from));
    if (!(askew <= kLine_m) || !(dot(ahead_, to - from) > 0))
      say("swath_direction", from, {askew, kLine_m},
          "swath " + swath.id + " is not parallel to the AB line, or runs from B to A: " + shown(askew, 3) +
              " m over its length");
    const double aside = cross((1.0 / 2) * (from + to) - a_, ahead_);
    const auto [known, added] = strips.emplace(*strip, aside);
    if (!added && !(std::abs(known->second - aside) <= kLine_m))
      say("swath_spacing", from, {aside, known->second},
          "swath " + swath.id + " lies " + shown(std::abs(aside - known->second), 3) +
              " m beside the other pieces of its strip");
  }

  /// Strips are as far apart as tool and overlap say; but for the last one, which ends with the ground where
  /// no AB line was given: then the first one's is the AB line, or that of one before it which is not driven.
  /// Seen from one that is given, and the shift, they lie at whole strips.
  void spacing(const std::map<int, double>& strips) {
    const Work& work = plan_.vehicle.work;
    const bool given = !work.ab.empty();
    if (strips.empty()) return;
    const double step = plan_.vehicle.machine.working_width_m - work.overlap_m;
    const auto [first, first_aside] = *strips.begin();
    const int steps =
        static_cast<int>(std::clamp(std::round(first_aside / step), 0.0, std::max(0.0, first - 1.0)));
    std::pair<int, double> from{first - steps, 0};  // of what the next strip is seen from
    if (given) from = {1, work.ab_shift_m};
    for (const auto& [number, aside] : strips) {
      const bool may_overlap = !given && number > from.first && number == strips.rbegin()->first;
      apart(from, {number, aside}, may_overlap);
      if (!given) from = {number, aside};
    }
  }

  void apart(std::pair<int, double> from, std::pair<int, double> to, bool may_overlap) {
    const Work& work = plan_.vehicle.work;
    const double told = (plan_.vehicle.machine.working_width_m - work.overlap_m) * (to.first - from.first);
    const double found = to.second - from.second;
    if (found <= told + kLine_m && (may_overlap ? found > 0 : found >= told - kLine_m)) return;
    say("swath_spacing", a_ + to.second * Point{ahead_.y_m, -ahead_.x_m}, {found, told},
        "strip " + std::to_string(to.first) + " lies " + shown(found, 3) + " m right of " +
            (work.ab.empty() ? "" : "the given line's ") + "strip " + std::to_string(from.first) +
            "; tool and overlap make it " + shown(told, 3) + " m");
  }

  Case& plan_;
  const AbRecord& ab_;
  Point a_;
  Point way_;  ///< from A to B
  double length_m_;
  Point ahead_;
};

}  // namespace

std::optional<int> strip_of(const std::string& id) {
  const bool left = id.starts_with('L');
  int number = 0;
  const char* from = id.data() + (left ? 1 : 0);
  if (std::from_chars(from, id.data() + id.size(), number).ec != std::errc{}) return std::nullopt;
  return left ? 1 - number : number;
}

void check_ab(Case& plan) {
  for (const Driven& driven : plan.drives)
    if (const int block = driven.record->block;
        std::ranges::count(plan.plan.ab_lines, block, &AbRecord::block) != 1)
      plan.findings.add("ab", block, std::nullopt, {}, "the block has no AB line, or several");
  for (const AbRecord& ab : plan.plan.ab_lines)
    if (plan.ground(ab.block) != nullptr &&
        std::ranges::count(plan.plan.ab_lines, ab.block, &AbRecord::block) == 1)
      AbCheck{plan, ab}.run();
}

}  // namespace selion::verifying
