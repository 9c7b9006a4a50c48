// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/output/map.hpp"

#include <algorithm>
#include <set>

#include "map_page.hpp"
#include "map_sheet.hpp"

namespace selion {
namespace {

Extent extent_of(const PlanFile& plan, const PlanPlane& plane) {
  Extent extent{{1e12, 1e12}, {-1e12, -1e12}};
  const auto add = [&](LonLat at) {
    const Point p = plane.to_local(at);
    extent.low = {std::min(extent.low.x_m, p.x_m), std::min(extent.low.y_m, p.y_m)};
    extent.high = {std::max(extent.high.x_m, p.x_m), std::max(extent.high.y_m, p.y_m)};
  };
  const auto add_all = [&](const LonLatLine& line) { std::for_each(line.begin(), line.end(), add); };
  for (const FieldRecord& field : plan.fields)
    for (const LonLatArea& part : field.parts) add_all(part.shell);
  for (const SwathRecord& swath : plan.swaths) add_all(swath.line);
  for (const TrajectoryRecord& trajectory : plan.trajectories) add_all(trajectory.line);
  for (const GateRecord& gate : plan.gates) add(gate.at);
  if (extent.low.x_m > extent.high.x_m) {
    const Point at = plane.to_local(plan.origin);
    return {at - Point{50, 50}, at + Point{50, 50}};
  }
  return extent;
}

void add_keep_outs(std::map<Mark, std::string>& legend, const PlanFile& plan) {
  bool holes = !plan.obstacles.empty();
  for (const FieldRecord& field : plan.fields)
    for (const LonLatArea& part : field.parts) holes = holes || !part.holes.empty();
  std::set<Mark> marks;
  if (holes) marks = {Mark::hole, Mark::small_hole};
  for (const ObstacleRecord& obstacle : plan.obstacles) {
    if (obstacle.what == "water") marks.insert(Mark::water);
    if (obstacle.what == "no_go") marks.insert(Mark::no_go);
  }
  for (const Mark mark : marks) legend[mark] = style_of(mark).legend;
}

/// The legend if everything in the plan is drawn, in the longest words that it may take.
std::map<Mark, std::string> longest_legend(const PlanFile& plan, const std::vector<DrawnTrack>& tracks) {
  std::map<Mark, std::string> legend;
  const auto may = [&](Mark mark, bool is) {
    if (is) legend[mark] = style_of(mark).legend;
  };
  may(Mark::boundary, !plan.fields.empty());
  may(Mark::headland, !plan.headlands.empty());
  if (!plan.headlands.empty()) legend[Mark::headland] += "; its passes are too close to draw";
  may(Mark::headland_pass, !plan.headland_passes.empty());
  may(Mark::undriven,
      std::any_of(plan.swaths.begin(), plan.swaths.end(), [](const SwathRecord& s) { return s.order == 0; }));
  may(Mark::cell, plan.cells.size() > 1);
  may(Mark::direction, !tracks.empty());
  for (const DrawnTrack& track : tracks)
    may(track.mark, track.mark == Mark::turn || track.mark == Mark::transfer || track.mark == Mark::reverse);
  for (const TrajectoryRecord& trajectory : plan.trajectories)
    for (const PieceRecord& piece : trajectory.pieces) may(Mark::pivot, piece.kind == "pivot");
  for (const Mark mark : {Mark::start, Mark::end}) may(mark, !plan.trajectories.empty());
  may(Mark::gate, !plan.gates.empty());
  may(Mark::ab, !plan.ab_lines.empty());
  add_keep_outs(legend, plan);
  if (!plan.swaths.empty())
    for (const Mark mark : {Mark::swath, Mark::swath_number, Mark::order})
      legend[mark] = std::string{style_of(mark).legend} + ", every 5000th drawn, and more";
  return legend;
}

void draw_items(Drawing& page, const std::vector<PanelItem>& items, const std::string& layer,
                PagePoint corner) {
  page.add(LayerStart{layer, {}});
  for (const PanelItem& item : items) {
    item.draw(page, corner);
    corner.y_mm += item.height_mm;
  }
  page.add(LayerEnd{});
}

void draw_map(MapSheet& sheet) {
  draw_graticule(sheet.page, sheet.view, sheet.font);
  sheet.page.add(LayerStart{"map", sheet.view.frame});
  draw_areas(sheet);
  draw_lanes(sheet);
  draw_boundary(sheet);
  draw_obstacles(sheet);
  draw_places(sheet);
  sheet.page.add(LayerEnd{});
  draw_place_names(sheet);
  draw_numbers(sheet);
  draw_obstacle_names(sheet);
  draw_order(sheet);
  draw_directions(sheet);
}

Drawing map_page(const PlanFile& plan, const MapText& text, const MapOptions& options, const Font& font) {
  const PlanPlane plane{plan.proj};
  const Extent extent = extent_of(plan, plane);
  const Point centre = 0.5 * (extent.low + extent.high);
  const auto longest = longest_legend(plan, tracks_of(plan, MapView{plane, {}, centre, 1}));
  const PageLayout layout = page_layout({plan, text, longest, extent}, font, options.paper);

  const MapView view{plane, layout.frame, centre, 1000 / layout.scale_denominator};
  MapSheet sheet{
      plan, view, font, options.units, tracks_of(plan, view), LabelPlacer{grown(layout.frame, -0.6)}, {}, {}};
  sheet.page.width_mm = layout.width_mm;
  sheet.page.height_mm = layout.height_mm;
  sheet.page.title = text.title;
  sheet.page.creator = "selion " + plan.version + ", plan " + plan.id;
  draw_items(sheet.page, layout.head, "head", {layout.content.left_mm, layout.content.top_mm});
  draw_map(sheet);
  draw_scale_and_north(sheet.page, view, font, layout.scale, options.units);
  sheet.page.add(LayerStart{"panel", {}});
  draw_flow(sheet.page, panel_items(font, text, sheet.drawn, layout), layout.panel, layout.panel_columns,
            kColumnGap_mm);
  sheet.page.add(LayerEnd{});
  draw_items(sheet.page, layout.foot, "foot", {layout.content.left_mm, layout.foot_top_mm});
  return std::move(sheet.page);
}

}  // namespace

void find_fonts() {
  const Font font;
  static_cast<void>(font.width_mm("0", TextStyle{}));
}

MapFiles map_files(const PlanFile& plan, const MapText& text, const MapOptions& options) {
  const Font font;
  const Drawing page = map_page(plan, text, options, font);
  return {to_svg(page, font), to_pdf(page, font)};
}

}  // namespace selion
