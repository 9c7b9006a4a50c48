// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kStray_m = 0.05;  // what lines of passes may stray along borders that are not straight
constexpr double kBehind = 0.5;    // of a pass's places
constexpr double kMostBehind = 0.9;
constexpr double kLong = 8;  // widths
constexpr double kLongRing_m = 100;
constexpr double kStep_m = 2;     // from place to place of a line
constexpr int kMostPlaces = 200;  // of it

double length_m(const std::vector<Point>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance_m(line[i - 1], line[i]);
  return length;
}

/// Evenly along a line.
std::vector<Point> places_of(const std::vector<Point>& line) {
  const double length = length_m(line);
  const int steps = std::min(kMostPlaces, 1 + static_cast<int>(length / kStep_m));
  std::vector<Point> places;
  std::size_t i = 1;
  double before = 0;  // the line's length as far as corner i - 1
  for (int k = 0; k < steps; ++k) {
    const double along = length * k / steps;
    while (i + 1 < line.size() && before + distance_m(line[i - 1], line[i]) < along) {
      before += distance_m(line[i - 1], line[i]);
      ++i;
    }
    places.push_back(line[i - 1] + (along - before) * unit(heading_rad(line[i] - line[i - 1])));
  }
  return places;
}

/// Headland passes of one block.
class RingCheck {
 public:
  RingCheck(Case& plan, const Ground& ground)
      : plan_{plan}, ground_{ground}, around_{border_of(ground.free)}, border_{ground.edge} {
    std::map<int, std::vector<Shape>> rings;
    for (const HeadlandPassRecord& pass : plan_.plan.headland_passes)
      if (pass.block == ground_.block)
        rings[pass.ring].push_back(line_through(plan_.plane.to_local(pass.line)));
    for (const auto& [ring, lines] : rings) rings_.emplace(ring, Prepared{united(lines)});
  }

  void run(const HeadlandRecord& headland) {
    const bool is_bare = !(area_m2(ground_.kept) > 0) && lines_of(around_.shape()).size() == 1;
    for (const HeadlandPassRecord& pass : plan_.plan.headland_passes) {
      if (pass.block != ground_.block) continue;
      const std::vector<Point> line = plan_.plane.to_local(pass.line);
      if (pass.ring > headland.passes)
        say(pass, line, {1.0 * pass.ring, 1.0 * headland.passes},
            " of a headland of " + std::to_string(headland.passes) + " passes");
      const std::vector<Point> places = places_of(line);
      const double usual = usual_distance_m(places, around_);
      lies_far_in(pass, line, places, usual);
      lies_outermost_of_its_ring(pass, line, places);
      keeps_margin(pass, line, is_bare ? usual : usual_distance_m(places, border_));
    }
  }

 private:
  void say(const HeadlandPassRecord& pass, const std::vector<Point>& line, const Measured& measured,
           const std::string& what) {
    plan_.findings.add("headland", ground_.block, line.front(), measured,
                       pass.id + " is said to be ring " + std::to_string(pass.ring) + what);
  }

  [[nodiscard]] bool is_long(const std::vector<Point>& line) const {
    return length_m(line) >= kLong * plan_.vehicle.machine.working_width_m;
  }

  /// Rings are numbered from the border, each lies a width farther in, or more; where it cannot, another lies
  /// between it and the border.
  void lies_far_in(const HeadlandPassRecord& pass, const std::vector<Point>& line,
                   const std::vector<Point>& places, double usual) {
    const double spacing = ring_spacing_m(plan_.vehicle);
    const double told = half_tool_m(plan_.vehicle) + (pass.ring - 1) * spacing;
    if (usual >= told - spacing / 2 || (pass.ring > 1 && behind(places, pass.ring - 1) > kBehind)) return;
    say(pass, line, {usual, told},
        ", " + shown(told, 1) + " m or more from border and obstacles; it lies " + shown(usual, 1) +
            " m off");
  }

  /// Between a long pass and the border lie passes of rings further out, none of its own or from further in.
  /// Short ones cross those round the next pole.
  void lies_outermost_of_its_ring(const HeadlandPassRecord& pass, const std::vector<Point>& line,
                                  const std::vector<Point>& places) {
    if (!is_long(line) || length_m(line) < kLongRing_m) return;
    if (const double share = behind(places, pass.ring); share > kMostBehind)
      say(pass, line, {share, kMostBehind},
          "; between it and the border lies another of that ring, or of one further in");
  }

  /// The share of the places that lie behind a pass of that ring, or of one further in, seen from the border.
  [[nodiscard]] double behind(const std::vector<Point>& places, int ring) const {
    const auto count = std::ranges::count_if(places, [&](Point p) { return is_behind(p, ring); });
    return static_cast<double>(count) / static_cast<double>(places.size());
  }

  /// Half a width off what is driven at the place itself.
  [[nodiscard]] bool is_behind(Point p, int ring) const {
    const double beside_m = ring_spacing_m(plan_.vehicle) / 2;
    const std::optional<Point> border = around_.nearest_to(p);
    if (!border || distance_m(p, *border) <= beside_m) return false;
    const std::array way{p + beside_m * unit(heading_rad(*border - p)), *border};
    return std::any_of(rings_.lower_bound(ring), rings_.end(),
                       [&](const auto& passes) { return passes.second.touches(way); });
  }

  /// A long line does; short ones lead into corners.
  void keeps_margin(const HeadlandPassRecord& pass, const std::vector<Point>& line, double off) {
    const double told = half_tool_m(plan_.vehicle) + plan_.vehicle.edge_margin_m;
    if (!is_long(line) || off >= told - kStray_m) return;
    plan_.findings.add("edge_margin", ground_.block, line.front(), {off, told},
                       pass.id + " lies " + shown(off, 3) +
                           " m from the border; tool, ring and edge margin make it " + shown(told, 3) + " m");
  }

  /// Of half of a line's places: it cuts corners and swings out round others. Past slits it leads far off.
  [[nodiscard]] static double usual_distance_m(const std::vector<Point>& places, const Prepared& border) {
    std::vector<double> off;
    off.reserve(places.size());
    for (const Point p : places) off.push_back(border.distance_m(std::array{p}));
    const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::ranges::nth_element(off, middle);
    return *middle;
  }

  Case& plan_;
  const Ground& ground_;
  Prepared around_;
  Prepared border_;
  std::map<int, Prepared> rings_;
};

}  // namespace

void check_rings(Case& plan) {
  for (const Ground& ground : plan.grounds)
    if (const auto headland = std::ranges::find(plan.plan.headlands, ground.block, &HeadlandRecord::block);
        headland != plan.plan.headlands.end())
      RingCheck{plan, ground}.run(*headland);
}

}  // namespace selion::verifying
