// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "map_sheet.hpp"

namespace selion {
namespace {

PageBox box_of(const std::vector<PageLine>& rings) {
  PageBox box{1e9, 1e9, -1e9, -1e9};
  for (const PageLine& ring : rings)
    for (const PagePoint p : ring)
      box = {std::min(box.left_mm, p.x_mm), std::min(box.top_mm, p.y_mm), std::max(box.right_mm, p.x_mm),
             std::max(box.bottom_mm, p.y_mm)};
  return box;
}

std::vector<PageLine> rings_of(const MapView& view, const LonLatArea& area) {
  std::vector<PageLine> rings = view.at(area);
  for (PageLine& ring : rings) ring = thinned(ring);
  std::erase_if(rings, [](const PageLine& ring) { return ring.size() < 2; });
  return rings;
}

struct KeepOut {
  Mark mark = Mark::hole;
  std::vector<PageLine> rings;
  std::string name;
};

Mark mark_of(const std::string& what) {
  if (what == "water") return Mark::water;
  return what == "no_go" ? Mark::no_go : Mark::hole;
}

/// What is too small to see becomes a symbol: a pylon must not be overlooked.
bool is_small(const PageBox& box) { return box.width_mm() < 1.6 && box.height_mm() < 1.6; }

std::vector<KeepOut> keep_outs(const PlanFile& plan, const MapView& view) {
  std::vector<KeepOut> found;
  const auto add = [&](const std::string& what, std::vector<PageLine> rings, const std::string& name) {
    if (rings.empty() || !overlap(box_of(rings), view.frame)) return;
    const Mark mark = is_small(box_of(rings)) ? Mark::small_hole : mark_of(what);
    found.push_back({mark, std::move(rings), name});
  };
  for (const FieldRecord& field : plan.fields)
    for (const LonLatArea& part : field.parts)
      for (const LonLatLine& hole : part.holes) add("hole", rings_of(view, {hole, {}}), "");
  for (const ObstacleRecord& obstacle : plan.obstacles)
    add(obstacle.what, rings_of(view, obstacle.area), obstacle.name);
  return found;
}

std::string name_on_map(const KeepOut& area) {
  if (!area.name.empty()) return area.name;
  if (area.mark == Mark::water) return "water";
  if (area.mark == Mark::no_go) return "no-go";
  return {};
}

/// One direction in the whole block: no border to show.
bool is_alone(const PlanFile& plan, const CellRecord& cell) {
  return std::none_of(plan.cells.begin(), plan.cells.end(),
                      [&](const CellRecord& c) { return c.block == cell.block && c.id != cell.id; });
}

void name_keep_outs(MapSheet& sheet, const std::vector<KeepOut>& areas) {
  for (const KeepOut& area : areas) {
    const PageBox box = box_of(area.rings);
    const std::string name = sheet.font.shortened(name_on_map(area), kSmall, 34);
    const double width_mm = sheet.font.width_mm(name, kSmall) + 1;
    // An area without a name of its own says what it is only where the word fits into it.
    if (name.empty() || (area.name.empty() && box.width_mm() < width_mm)) continue;
    std::vector<PageBox> candidates{box_around(box.centre(), width_mm, 3)};
    if (area.mark == Mark::small_hole) candidates.clear();
    const std::vector<PageBox> beside =
        boxes_near(box.centre(), width_mm, 3, std::max(box.width_mm(), box.height_mm()) / 2 + 0.5, 15);
    candidates.insert(candidates.end(), beside.begin(), beside.end());
    if (const auto place = sheet.placer.place(candidates)) draw_label(sheet.page, *place, name, kSmall);
  }
}

}  // namespace

void draw_areas(MapSheet& sheet) {
  in_layer(sheet, Mark::headland, [&] {
    for (const HeadlandRecord& headland : sheet.plan.headlands)
      for (const LonLatArea& part : headland.parts)
        draw_area(sheet.page, Mark::headland, rings_of(sheet.view, part));
  });
  if (sheet.drawn.contains(Mark::headland) && !sheet.plan.headland_passes.empty() &&
      is_crowded(sheet.plan, sheet.view))
    sheet.drawn[Mark::headland] += "; its passes are too close to draw";
  in_layer(sheet, Mark::cell, [&] {
    for (const CellRecord& cell : sheet.plan.cells) {
      if (is_alone(sheet.plan, cell)) continue;
      for (const LonLatArea& part : cell.parts)
        sheet.page.add(PageShape{rings_of(sheet.view, part), Ends::closed, {}, style_of(Mark::cell).stroke});
    }
  });
}

void draw_obstacles(MapSheet& sheet) {
  const std::vector<KeepOut> areas = keep_outs(sheet.plan, sheet.view);
  for (const Mark mark : {Mark::no_go, Mark::hole, Mark::water})
    in_layer(sheet, mark, [&] {
      for (const KeepOut& area : areas)
        if (area.mark == mark) draw_area(sheet.page, mark, area.rings);
    });
  in_layer(sheet, Mark::small_hole, [&] {
    for (const KeepOut& area : areas) {
      if (area.mark != Mark::small_hole) continue;
      const PagePoint at = box_of(area.rings).centre();
      draw_small_hole(sheet.page, at);
      sheet.placer.take(box_around(at, 2.6, 2.6));
    }
  });
}

void draw_boundary(MapSheet& sheet) {
  Stroke boundary = *style_of(Mark::boundary).stroke;
  if (is_crowded(sheet.plan, sheet.view)) boundary.width_mm = 0.45;  // else it would hide the headland
  in_layer(sheet, Mark::boundary, [&] {
    for (const FieldRecord& field : sheet.plan.fields)
      for (const LonLatArea& part : field.parts)
        sheet.page.add(PageShape{{thinned(sheet.view.at(part.shell))}, Ends::closed, {}, boundary});
  });
}

void draw_obstacle_names(MapSheet& sheet) {
  sheet.page.add(LayerStart{"names", {}});
  name_keep_outs(sheet, keep_outs(sheet.plan, sheet.view));
  sheet.page.add(LayerEnd{});
}

}  // namespace selion
