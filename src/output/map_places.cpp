// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "map_sheet.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"

namespace selion {
namespace {

void draw_leader(Drawing& page, PagePoint from, PagePoint to) {
  page.add(PageShape{{{from, to}}, Ends::open, {}, Stroke{kBlack, 0.25, {}}});
  page.add(PageShape{{circle(from, 0.4)}, Ends::closed, kBlack, {}});
}

/// Beside `at` where that is taken, with a line to it.
void draw_end_of_route(MapSheet& sheet, Mark mark, PagePoint at, const std::string& letters) {
  const double size_mm = 2 * kDisc_mm + 0.5;
  std::vector<PageBox> candidates{box_around(at, size_mm, size_mm)};
  const std::vector<PageBox> beside = boxes_near(at, size_mm, size_mm, 1, 30);
  candidates.insert(candidates.end(), beside.begin(), beside.end());
  const PageBox box = sheet.placer.place(candidates).value_or(candidates.front());
  if (distance_mm(box.centre(), at) > 0.1) draw_leader(sheet.page, at, box.centre());
  draw_disc(sheet.page, mark, box.centre(), letters);
}

void draw_ends(MapSheet& sheet, Mark mark) {
  in_layer(sheet, mark, [&] {
    const std::vector<TrajectoryRecord>& trajectories = sheet.plan.trajectories;
    for (std::size_t i = 0; i < trajectories.size(); ++i) {
      if (trajectories[i].line.empty()) continue;
      const bool start = mark == Mark::start;
      const LonLat at = start ? trajectories[i].line.front() : trajectories[i].line.back();
      const std::string number = trajectories.size() > 1 ? std::to_string(i + 1) : "";
      draw_end_of_route(sheet, mark, sheet.view.at(at), (start ? "S" : "E") + number);
    }
  });
}

void draw_gates(MapSheet& sheet) {
  in_layer(sheet, Mark::gate, [&] {
    for (const GateRecord& gate : sheet.plan.gates) {
      const PagePoint at = sheet.view.at(gate.at);
      if (!holds(sheet.view.frame, at)) continue;
      draw_gate(sheet.page, at);
      sheet.placer.take(box_around(at, 2 * kGate_mm + 0.5, 2 * kGate_mm + 0.5));
    }
  });
}

/// The A and the B corner, where one of them is on the sheet.
std::vector<std::array<PagePoint, 2>> ab_lines_in_sight(const MapSheet& sheet) {
  std::vector<std::array<PagePoint, 2>> lines;
  for (const AbRecord& ab : sheet.plan.ab_lines) {
    const std::array<PagePoint, 2> line{sheet.view.at(ab.a), sheet.view.at(ab.b)};
    if (holds(sheet.view.frame, line[0]) || holds(sheet.view.frame, line[1])) lines.push_back(line);
  }
  return lines;
}

void draw_ab_lines(MapSheet& sheet) {
  const auto lines = ab_lines_in_sight(sheet);
  if (lines.empty()) return;
  in_layer(sheet, Mark::ab, [&] {
    for (const auto& [a, b] : lines) {
      draw_lines(sheet.page, Mark::ab, {{a, b}});
      for (const PagePoint corner : {a, b}) {
        if (!holds(sheet.view.frame, corner)) continue;
        draw_corner(sheet.page, corner);
        sheet.placer.take(box_around(corner, 1.7, 1.7));
      }
    }
  });
}

/// "012.5": three digits before the point, as on a guidance display.
std::string bearing_words(double bearing_deg) {
  double turned = std::fmod(bearing_deg, 360);
  if (turned < 0) turned += 360;
  std::string digits = fixed(turned, 1);
  if (digits == "360.0") digits = "0.0";
  return std::string(5 - std::min<std::size_t>(5, digits.size()), '0') + digits;
}

/// With a gap of nothing the name stands on the place itself, where that is free.
bool name_near(MapSheet& sheet, PagePoint at, const std::string& name, TextStyle style, double gap_mm) {
  const double width_mm = sheet.font.width_mm(name, style) + 1;
  const double height_mm = cap_height_mm(style) + 1.1;
  std::vector<PageBox> candidates = boxes_near(at, width_mm, height_mm, gap_mm, 22);
  if (gap_mm <= 0) candidates.insert(candidates.begin(), box_around(at, width_mm, height_mm));
  const auto place = sheet.placer.place(candidates);
  if (!place) return false;
  const PagePoint nearest{std::clamp(at.x_mm, place->left_mm, place->right_mm),
                          std::clamp(at.y_mm, place->top_mm, place->bottom_mm)};
  if (distance_mm(nearest, at) > gap_mm * 1.5 + 1.5)
    sheet.page.add(PageShape{{{at, nearest}}, Ends::open, {}, Stroke{kBlack, 0.25, {}}});
  draw_label(sheet.page, *place, name, style);
  return true;
}

void name_gates(MapSheet& sheet) {
  for (std::size_t i = 0; i < sheet.plan.gates.size(); ++i) {
    const GateRecord& gate = sheet.plan.gates[i];
    const PagePoint at = sheet.view.at(gate.at);
    if (!holds(sheet.view.frame, at)) continue;
    std::string name =
        sheet.font.shortened(gate.name.empty() ? "Gate " + std::to_string(i + 1) : gate.name, kSmallBold, 40);
    if (gate.width_m)
      name += sheet.units == Units::metric ? " (" + fixed(*gate.width_m, 1) + " m)"
                                           : " (" + fixed(feet_of_m(*gate.width_m), 0) + " ft)";
    name_near(sheet, at, name, kSmallBold, kGate_mm + 0.4);
  }
}

void name_ab_lines(MapSheet& sheet) {
  for (const AbRecord& ab : sheet.plan.ab_lines) {
    const PagePoint a = sheet.view.at(ab.a);
    const PagePoint b = sheet.view.at(ab.b);
    if (holds(sheet.view.frame, a)) name_near(sheet, a, "A", kHeading, 0.9);
    if (holds(sheet.view.frame, b)) name_near(sheet, b, "B", kHeading, 0.9);
    for (const double share : {0.0, 0.5, 1.0, 0.25, 0.75}) {
      const PagePoint at{a.x_mm + share * (b.x_mm - a.x_mm), a.y_mm + share * (b.y_mm - a.y_mm)};
      if (holds(sheet.view.frame, at) &&
          name_near(sheet, at, "AB " + bearing_words(ab.bearing_deg) + "\u00B0", kSmallBold, 0.9))
        break;
    }
  }
}

/// Mean of the corners of what the block is made of: near its middle, which is all that a name needs.
std::optional<PagePoint> middle_of_block(const MapSheet& sheet, int block) {
  PagePoint sum;
  double corners = 0;
  const auto add = [&](const LonLatLine& line) {
    for (const LonLat p : line) {
      const PagePoint at = sheet.view.at(p);
      sum = {sum.x_mm + at.x_mm, sum.y_mm + at.y_mm};
      ++corners;
    }
  };
  for (const SwathRecord& swath : sheet.plan.swaths)
    if (swath.block == block) add(swath.line);
  for (const HeadlandPassRecord& pass : sheet.plan.headland_passes)
    if (pass.block == block && corners == 0) add(pass.line);
  if (corners == 0) return std::nullopt;
  return PagePoint{sum.x_mm / corners, sum.y_mm / corners};
}

void name_blocks(MapSheet& sheet) {
  std::set<int> blocks;
  for (const SwathRecord& swath : sheet.plan.swaths) blocks.insert(swath.block);
  for (const HeadlandPassRecord& pass : sheet.plan.headland_passes) blocks.insert(pass.block);
  if (blocks.size() < 2) return;
  for (const int block : blocks)
    if (const auto at = middle_of_block(sheet, block))
      name_near(sheet, *at, "Block " + std::to_string(block), kHeading, 0);
}

}  // namespace

void draw_places(MapSheet& sheet) {
  draw_ab_lines(sheet);
  draw_gates(sheet);
  draw_ends(sheet, Mark::start);
  draw_ends(sheet, Mark::end);
}

void draw_place_names(MapSheet& sheet) {
  sheet.page.add(LayerStart{"place-names", {}});
  name_ab_lines(sheet);
  name_gates(sheet);
  name_blocks(sheet);
  sheet.page.add(LayerEnd{});
}

}  // namespace selion
