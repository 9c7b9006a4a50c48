// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "map_sheet.hpp"
#include "selion/motion/path.hpp"

namespace selion {
namespace {

constexpr double kApart_mm = 0.55;  // between lines, so that they do not run together

/// What a piece looks like; none of a wait and a pivot, which lead nowhere.
std::optional<Mark> mark_of(const PieceRecord& piece) {
  if (piece.kind == "wait" || piece.kind == "pivot") return std::nullopt;
  if (piece.gear < 0) return Mark::reverse;
  if (piece.kind == "transfer") return Mark::transfer;
  if (piece.kind == "turn" || piece.tool == 0) return Mark::turn;
  return piece.kind == "headland_pass" ? Mark::headland_pass : Mark::swath;
}

Curve curve_of(const PieceRecord& piece) {
  return {{piece.x_m, piece.y_m},
          piece.heading_rad,
          piece.curvature_per_m,
          piece.sharpness_per_m2,
          piece.length_m};
}

/// Chords of at most a tenth of a radian: finer than paper shows on a turn.
PageLine line_of(const PieceRecord& piece, const MapView& view) {
  const Curve curve = curve_of(piece);
  const double bend_rad = std::abs(curve.curvature_per_m) * curve.length_m +
                          std::abs(curve.sharpness_per_m2) * curve.length_m * curve.length_m / 2;
  const int chords = std::clamp(static_cast<int>(std::ceil(bend_rad / 0.1)), 1, 500);
  PageLine line;
  for (int i = 0; i <= chords; ++i) {
    const CurveState state = state_at(curve, curve.length_m * i / chords);
    line.push_back(view.at(state.at + piece.offset_m * left_of(unit(state.heading_rad))));
  }
  return line;
}

/// Where passes are crowded a U-turn is a dot of ink, and is left out.
std::vector<PageLine> lines_of(const MapSheet& sheet, Mark mark) {
  const double least_mm = is_crowded(sheet.plan, sheet.view) ? 2.5 : 0;
  std::vector<PageLine> lines;
  for (const DrawnTrack& track : sheet.tracks)
    if (track.mark == mark && length_mm(track.line) >= least_mm) lines.push_back(thinned(track.line));
  return lines;
}

void draw_swaths(MapSheet& sheet) {
  const int step = drawn_step(sheet.plan, sheet.view);
  const auto strips = strips_by_block(sheet.plan);
  std::vector<PageLine> driven;
  std::vector<PageLine> undriven;
  for (const SwathRecord& swath : sheet.plan.swaths)
    if (swath.line.size() > 1 && is_in_step(swath, strips.at(swath.block), step))
      (swath.order > 0 ? driven : undriven).push_back(thinned(sheet.view.at(swath.line)));
  if (step > 1)
    sheet.drawn[Mark::swath] = std::string{style_of(Mark::swath).legend} + ", every " + std::to_string(step) +
                               "th drawn, without U-turns";
  if (driven.empty()) sheet.drawn.erase(Mark::swath);
  in_layer(sheet, Mark::undriven, [&] {
    if (!undriven.empty()) draw_lines(sheet.page, Mark::undriven, undriven);
  });
  in_layer(sheet, Mark::swath, [&] {
    if (!driven.empty()) draw_lines(sheet.page, Mark::swath, driven);
  });
}

void draw_pivots(MapSheet& sheet) {
  in_layer(sheet, Mark::pivot, [&] {
    for (const TrajectoryRecord& trajectory : sheet.plan.trajectories)
      for (const PieceRecord& piece : trajectory.pieces)
        if (piece.kind == "pivot")
          draw_pivot(sheet.page, sheet.view.at(Point{piece.x_m, piece.y_m} +
                                               piece.offset_m * left_of(unit(piece.heading_rad))));
  });
}

}  // namespace

std::vector<DrawnTrack> tracks_of(const PlanFile& plan, const MapView& view) {
  constexpr double kJoined_mm = 0.01;
  std::vector<DrawnTrack> tracks;
  for (const TrajectoryRecord& trajectory : plan.trajectories) {
    bool joins = false;
    for (const PieceRecord& piece : trajectory.pieces) {
      const auto mark = mark_of(piece);
      if (!mark) continue;
      const std::string ref = *mark == Mark::swath || *mark == Mark::headland_pass ? piece.ref : "";
      PageLine line = line_of(piece, view);
      joins = joins && tracks.back().mark == *mark && tracks.back().ref == ref &&
              distance_mm(tracks.back().line.back(), line.front()) < kJoined_mm;
      if (joins)
        tracks.back().line.insert(tracks.back().line.end(), line.begin() + 1, line.end());
      else
        tracks.push_back({*mark, ref, std::move(line)});
      joins = true;
    }
  }
  return tracks;
}

int strip_number(const std::string& id) {
  int number = 0;
  for (const char c : id) {
    if (c < '0' || c > '9' || number > 100'000'000) break;
    number = 10 * number + (c - '0');
  }
  return number;
}

std::map<int, StripRange> strips_by_block(const PlanFile& plan) {
  std::map<int, StripRange> blocks;
  for (const SwathRecord& swath : plan.swaths) {
    const int number = strip_number(swath.id);
    StripRange& range = blocks[swath.block];
    if (number == 0) continue;
    range.first = range.first == 0 ? number : std::min(range.first, number);
    range.last = std::max(range.last, number);
  }
  return blocks;
}

bool is_in_step(const SwathRecord& swath, StripRange strips, int step) {
  const int number = strip_number(swath.id);
  return number == 0 || number == strips.first || number == strips.last || number % step == 0;
}

int drawn_step(const PlanFile& plan, const MapView& view) {
  if (plan.swaths.empty()) return 1;
  double width_m = 1e9;
  for (const SwathRecord& swath : plan.swaths) width_m = std::min(width_m, swath.width_m);
  for (const int step : {1, 5, 15, 25})
    if (step * width_m * view.mm_per_m >= kApart_mm) return step;
  return 125;
}

bool is_crowded(const PlanFile& plan, const MapView& view) {
  double width_m = 1e9;
  for (const HeadlandPassRecord& pass : plan.headland_passes) width_m = std::min(width_m, pass.width_m);
  return drawn_step(plan, view) > 1 || width_m * view.mm_per_m < kApart_mm;
}

void draw_lanes(MapSheet& sheet) {
  in_layer(sheet, Mark::headland_pass, [&] {
    std::vector<PageLine> lines;
    for (const HeadlandPassRecord& pass : sheet.plan.headland_passes)
      if (pass.line.size() > 1 && pass.width_m * sheet.view.mm_per_m >= kApart_mm)
        lines.push_back(thinned(sheet.view.at(pass.line)));
    if (!lines.empty()) draw_lines(sheet.page, Mark::headland_pass, lines);
  });
  draw_swaths(sheet);
  for (const Mark mark : {Mark::turn, Mark::transfer, Mark::reverse})
    in_layer(sheet, mark, [&] {
      if (auto lines = lines_of(sheet, mark); !lines.empty()) draw_lines(sheet.page, mark, std::move(lines));
    });
  draw_pivots(sheet);
}

}  // namespace selion
