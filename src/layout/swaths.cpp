// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parts.hpp"
#include "selion/core/format.hpp"

namespace selion {
namespace {

constexpr double kTrim_m = 0.25;
constexpr double kRunPast_m = 1;  // strips reach this far beyond what they are cut with

/// Along the swaths (a) and across them, to the right of A -> B (c).
struct Axes {
  Point along;
  Point right;

  [[nodiscard]] Point at(double a_m, double c_m) const { return a_m * along + c_m * right; }
};

/// One strip's centre, across, and its number: 1, 2, ... to the right from the AB line, 0, -1, ... to its
/// left.
struct Strip {
  int number = 1;
  double c_m = 0;
};

std::vector<Strip> strips_from_line(double line_m, AxisExtent across, double width_m, double spacing_m) {
  std::vector<Strip> strips;
  const auto first = static_cast<int>(std::floor((across.low_m - width_m / 2 - line_m) / spacing_m)) + 1;
  for (int k = first; line_m + k * spacing_m - width_m / 2 < across.high_m; ++k)
    strips.push_back({k + 1, line_m + k * spacing_m});
  return strips;
}

/// From the low side; the last one is shifted back to end with the area. No strip is added for what no border
/// is known to.
std::vector<Strip> strips_to_fit(AxisExtent across, double width_m, double spacing_m) {
  constexpr double kSame_m = 0.01;
  const double span = across.high_m - across.low_m;
  if (span <= width_m + kSame_m) return {{1, (across.low_m + across.high_m) / 2}};
  const int count = static_cast<int>(std::ceil((span - width_m - kSame_m) / spacing_m)) + 1;
  std::vector<Strip> strips;
  strips.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    strips.push_back(
        {k + 1, std::min(across.low_m + width_m / 2 + k * spacing_m, across.high_m - width_m / 2)});
  return strips;
}

/// What of the strip is to be worked, along its axis: each part's full extent, so that slanted ends leave no
/// wedge.
std::vector<AxisExtent> wanted(const Polygons& mainland, const Axes& axes, double c_m, AxisExtent along,
                               double width_m) {
  const double least_m2 = 0.02 * width_m * width_m;  // not worth a pass
  const Ring rectangle =
      strip(axes.at(along.low_m - kRunPast_m, c_m), axes.at(along.high_m + kRunPast_m, c_m), width_m);
  std::vector<AxisExtent> parts;
  for (const Polygon& part : intersect(mainland, {Polygon{rectangle, {}}})) {
    if (area_m2(part) < least_m2) continue;
    parts.push_back(extent_of({part}, axes.along));
  }
  std::sort(parts.begin(), parts.end(),
            [](const AxisExtent& p, const AxisExtent& q) { return p.low_m < q.low_m; });
  std::vector<AxisExtent> merged;
  for (const AxisExtent& part : parts) {
    if (!merged.empty() && part.low_m - merged.back().high_m < width_m)
      merged.back().take(part.high_m);
    else
      merged.push_back(part);
  }
  return merged;
}

std::string strip_name(int number) {
  return number >= 1 ? std::to_string(number) : "L" + std::to_string(1 - number);
}

/// Shortens the piece until the machine fits at both of its ends, driven either way.
std::optional<Swath> trimmed(const Ground& ground, Swath piece) {
  for (int round = 0; round < 40; ++round) {
    const double length = distance_m(piece.from, piece.to);
    if (length < 2 * kTrim_m) return std::nullopt;
    const Path there = swath_path(ground.machine, piece.from, piece.to);
    const Path back = swath_path(ground.machine, piece.to, piece.from);
    const auto both_fit = [&](const Path& begun, const Path& ended) {
      return fits(ground.space, ground.footprint, start_pose(begun)) &&
             fits(ground.space, ground.footprint, end_pose(ended));
    };
    const bool far_end = both_fit(back, there);
    const bool near_end = both_fit(there, back);
    if (far_end && near_end)
      return fits(ground.space, ground.footprint, there) ? std::optional{piece} : std::nullopt;
    const Point step = (kTrim_m / length) * (piece.to - piece.from);
    if (!far_end) piece.to = piece.to - step;
    if (!near_end) piece.from = piece.from + step;
  }
  return std::nullopt;
}

/// Shortened to what can be left again, driven the way that leaves more; absent where nothing is left.
std::optional<Swath> passable(const Ground& ground, Swath piece) {
  if (ground.machine.may_reverse) return piece;
  const double length = distance_m(piece.from, piece.to);
  const Point axis = (1 / length) * (piece.to - piece.from);
  const AxisExtent forth = without_dead_ends(ground, piece, {0, length});
  AxisExtent best = forth;
  if (length_m(forth) < length) {
    const AxisExtent back =
        without_dead_ends(ground, {piece.id, piece.strip, piece.to, piece.from}, {0, length});
    if (length_m(back) > length_m(forth)) best = {length - back.high_m, length - back.low_m};
  }
  if (length_m(best) < 2 * kTrim_m) return std::nullopt;
  const Point a = piece.from;
  piece.from = a + best.low_m * axis;
  piece.to = a + best.high_m * axis;
  return piece;
}

}  // namespace

Ring strip(Point a, Point b, double width_m) {
  const Point side = (width_m / 2 / distance_m(a, b)) * left_of(b - a);
  return {a - side, b - side, b + side, a + side};
}

Path swath_path(const Machine& machine, Point from, Point to) {
  const Point ahead = (-machine.tool_x_m / distance_m(from, to)) * (to - from);
  return {{line(from + ahead, to + ahead), Gear::forward}};
}

std::vector<Span1> drivable_spans(const Ground& ground, Point a, Point b) {
  const double length = distance_m(a, b);
  const Point along = (1 / length) * (b - a);
  std::vector<Span1> blocked;
  for (const Polygon& part :
       subtract({Polygon{strip(a, b, ground.machine.working_width_m - 2e-3), {}}}, ground.workable)) {
    AxisExtent span;
    for (const Point p : part.shell) span.take(dot(p - a, along));
    blocked.push_back({span.low_m, span.high_m});
  }
  std::sort(blocked.begin(), blocked.end(),
            [](const Span1& p, const Span1& q) { return p.from_m < q.from_m; });
  std::vector<Span1> spans;
  double from = 0;
  for (const Span1& block : blocked) {
    if (block.from_m > from) spans.push_back({from, block.from_m});
    from = std::max(from, block.to_m);
  }
  if (from < length) spans.push_back({from, length});
  return spans;
}

namespace {

/// What the machine can drive of the strip's parts, cut where something is in the way.
std::vector<Swath> pieces_on(const Ground& ground, const Axes& axes, const Strip& row,
                             const std::vector<AxisExtent>& parts) {
  std::vector<Swath> pieces;
  for (const AxisExtent& part : parts) {
    const Point a = axes.at(part.low_m, row.c_m);
    const Point b = axes.at(part.high_m, row.c_m);
    for (const Span1& span : drivable_spans(ground, a, b))
      if (auto piece =
              trimmed(ground, {"", row.number, a + span.from_m * axes.along, a + span.to_m * axes.along}))
        if (const auto way = passable(ground, *piece)) pieces.push_back(*way);
  }
  for (std::size_t k = 0; k < pieces.size(); ++k)
    pieces[k].id = strip_name(row.number) + (pieces.size() > 1 ? letters_of(k) : "");
  return pieces;
}

std::vector<Swath> swaths_on(const Ground& ground, const Polygons& mainland, const Axes& axes,
                             const std::vector<Strip>& strips) {
  const AxisExtent along = extent_of(mainland, axes.along);
  const double width = ground.machine.working_width_m;
  std::vector<Swath> swaths;
  for (const Strip& row : strips) {
    const auto pieces = pieces_on(ground, axes, row, wanted(mainland, axes, row.c_m, along, width));
    swaths.insert(swaths.end(), pieces.begin(), pieces.end());
  }
  return swaths;
}

double length_of_all_m(const std::vector<Swath>& swaths) {
  double sum = 0;
  for (const Swath& swath : swaths) sum += distance_m(swath.from, swath.to);
  return sum;
}

/// For where hardly a strip laid from the sides in fits (a crooked band little wider than the machine): laid
/// so far from a side that they are longest.
std::vector<Swath> swaths_where_longest(const Ground& ground, const Polygons& mainland, const Axes& axes,
                                        AxisExtent across, double spacing_m) {
  constexpr int kPlaces = 16;
  const double width = ground.machine.working_width_m;
  const double room_m = length_m(across) - width;
  std::vector<Swath> longest;
  for (int i = 1; i < kPlaces && room_m > 0; ++i) {
    const double shift_m = std::min(room_m, spacing_m) * i / kPlaces;
    std::vector<Strip> strips;
    for (int k = 0; shift_m + k * spacing_m <= room_m; ++k)
      strips.push_back({k + 1, across.low_m + width / 2 + shift_m + k * spacing_m});
    std::vector<Swath> swaths = swaths_on(ground, mainland, axes, strips);
    if (length_of_all_m(swaths) > length_of_all_m(longest)) longest = std::move(swaths);
  }
  return longest;
}

std::vector<Swath> swaths_from_side(const Ground& ground, const Polygons& mainland,
                                    const LayoutOptions& options, double heading) {
  const double width = ground.machine.working_width_m;
  const Axes axes{unit(heading), -1 * left_of(unit(heading))};
  const AxisExtent across = extent_of(mainland, axes.right);
  const double spacing = width - options.overlap_m;
  if (options.ab) {
    const double line_m = dot(options.ab->a, axes.right) + options.ab_shift_m;
    return swaths_on(ground, mainland, axes, strips_from_line(line_m, across, width, spacing));
  }
  auto swaths = swaths_on(ground, mainland, axes, strips_to_fit(across, width, spacing));
  const bool narrow = length_m(across) < 2 * width;
  if (!narrow && !swaths.empty()) return swaths;
  auto others = swaths_where_longest(ground, mainland, axes, across, spacing);
  return length_of_all_m(others) > length_of_all_m(swaths) ? others : swaths;
}

/// Without those shorter than `least_m`, unless there are no others.
std::vector<Swath> swaths_along(const Ground& ground, const Polygons& mainland, const LayoutOptions& options,
                                double heading, double least_m) {
  std::vector<Swath> swaths = swaths_from_side(ground, mainland, options, heading);
  const auto is_short = [&](const Swath& swath) { return distance_m(swath.from, swath.to) < least_m; };
  if (!std::all_of(swaths.begin(), swaths.end(), is_short)) std::erase_if(swaths, is_short);
  return swaths;
}

double length_of_strip_m(const std::vector<Swath>& swaths, int strip) {
  double sum = 0;
  for (const Swath& swath : swaths)
    if (swath.strip == strip) sum += distance_m(swath.from, swath.to);
  return sum;
}

}  // namespace

std::vector<Swath> lay_swaths(const Ground& ground, const Polygons& mainland, const LayoutOptions& options,
                              double least_m, AbLine& ab) {
  if (options.ab) {
    ab = *options.ab;
    return swaths_along(ground, mainland, options, heading_rad(ab.b - ab.a), least_m);
  }
  const double heading = options.heading_rad.value_or(options.along.radians());
  std::vector<Swath> swaths = swaths_along(ground, mainland, options, heading, least_m);
  if (swaths.empty()) return swaths;
  // numbered from the longer side: a long AB line, and the shifted last strip where it overlaps least
  if (!options.heading_rad &&
      length_of_strip_m(swaths, swaths.back().strip) > length_of_strip_m(swaths, swaths.front().strip) + 1)
    swaths = swaths_along(ground, mainland, options, heading + std::numbers::pi, least_m);
  const auto last = std::find_if(swaths.rbegin(), swaths.rend(),
                                 [&](const Swath& swath) { return swath.strip == swaths.front().strip; });
  ab = {swaths.front().from, last->to};
  return swaths;
}

}  // namespace selion
