// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kDepth_m = 0.02;
constexpr double kRounding_m = 1e-3;  // of ground along its border
constexpr double kRounding_m2 = 0.1;

Shape shape_of(const Plane& plane, const std::vector<LonLatArea>& parts) {
  std::vector<Shape> shapes;
  for (const LonLatArea& part : parts) {
    Outline outline{plane.to_local(part.shell), {}};
    for (const LonLatLine& hole : part.holes) outline.holes.push_back(plane.to_local(hole));
    shapes.push_back(made_valid(polygon_of(outline)));
  }
  return united(shapes);
}

/// Headland and cells of one block, and that no swath is called a headland pass.
class HeadlandCheck {
 public:
  HeadlandCheck(Case& plan, const Ground& ground, const HeadlandRecord& headland)
      : plan_{plan}, ground_{ground}, headland_{headland} {}

  void run() {
    depth();
    shares();
    passes();
  }

 private:
  void say(const Measured& measured, const std::string& what, std::optional<Point> at = std::nullopt) {
    plan_.findings.add("headland", ground_.block, at, measured, what);
  }

  /// As deep as edge margin and passes make it.
  void depth() {
    const double margin = plan_.vehicle.edge_margin_m;
    const int passes = headland_.passes;
    const double deep = passes == 0 ? margin
                                    : margin + half_tool_m(plan_.vehicle) +
                                          plan_.vehicle.machine.working_width_m / 2 +
                                          (passes - 1) * ring_spacing_m(plan_.vehicle);
    if (!(std::abs(headland_.depth_m - deep) <= kDepth_m))
      say({headland_.depth_m, deep}, "the headland is said to be " + shown(headland_.depth_m, 2) +
                                         " m deep; " + std::to_string(passes) +
                                         " passes and the edge margin make it " + shown(deep, 2) + " m");
    const auto asked = plan_.vehicle.work.passes;
    if (asked && *asked != passes)
      say({1.0 * passes, *asked}, "the headland is said to have " + std::to_string(passes) +
                                      " passes, the job asks for " + shown(*asked, 0));
  }

  /// The block is headland and cells, nothing twice; the cells lie as deep as is said.
  void shares() {
    std::vector<LonLatArea> parts;
    for (const CellRecord& cell : plan_.plan.cells)
      if (cell.block == ground_.block) parts.insert(parts.end(), cell.parts.begin(), cell.parts.end());
    const Shape& cells = cells_ = shape_of(plan_.plane, parts);
    const Shape band = shape_of(plan_.plane, headland_.parts);
    const Shape both = united({band, cells});
    const double slack = kRounding_m2 + kRounding_m * (perimeter_m(band) + perimeter_m(cells));
    const double both_m2 = area_m2(both);
    const double in_block_m2 = area_m2(common(ground_.area, both));
    const auto tell = [&](double area, const std::string& what, const std::function<Shape()>& where) {
      if (area > kRounding_m2) tell_of(where(), slack, what);
    };
    tell(area_m2(band) + area_m2(cells) - both_m2, "are said to be headland and cell",
         [&] { return common(band, cells); });
    double sum = 0;
    for (const LonLatArea& part : parts) sum += area_m2(shape_of(plan_.plane, {part}));
    if (const double twice = sum - area_m2(cells); twice > slack)
      say({twice, slack}, shown(twice, 1) + " m2 are said to be two cells");
    tell(area_m2(ground_.area) - in_block_m2, "of the block are neither headland nor cell",
         [&] { return without(ground_.area, both); });
    tell(both_m2 - in_block_m2, "of headland and cells lie outside the block",
         [&] { return without(both, ground_.area); });
    if (parts.empty()) return;
    const double near = distance_m(cells, ground_.edge);
    if (!(near >= headland_.depth_m - kDepth_m))
      say({near, headland_.depth_m}, "a cell lies " + shown(near, 2) +
                                         " m from the border; the headland is said to be " +
                                         shown(headland_.depth_m, 2) + " m deep");
  }

  /// All together, or one place that is larger than rounding along its border makes.
  void tell_of(const Shape& ground, double slack, const std::string& what) {
    const auto say_of = [&](const Shape& where, double most) {
      say({area_m2(where), most}, shown(area_m2(where), 1) + " m2 " + what, place_in(where));
    };
    if (area_m2(ground) > slack) return say_of(ground, slack);
    for (const Shape& part : parts_of(ground))
      if (const double most = kRounding_m2 + kRounding_m * perimeter_m(part); area_m2(part) > most)
        return say_of(part, most);
  }

  void passes() {
    for (const HeadlandPassRecord& pass : plan_.plan.headland_passes)
      if (pass.block == ground_.block) is_no_swath(pass, plan_.plane.to_local(pass.line));
  }

  /// How much of the line from `a` lies beside swaths whose middle is nearer than half a width.
  [[nodiscard]] double worked_by_swaths_m(Point a, Point along, double length) const {
    double worked = 0;
    for (const SwathRecord& swath : plan_.plan.swaths) {
      if (swath.block != ground_.block || swath.line.empty()) continue;
      const Point from = plan_.plane.to_local(swath.line.front()) - a;
      const Point to = plan_.plane.to_local(swath.line.back()) - a;
      if (std::abs(cross(along, from + to)) >= plan_.vehicle.machine.working_width_m) continue;
      const auto [low, high] = std::minmax({dot(along, from), dot(along, to)});
      worked += std::max(0.0, std::min(high, length) - std::max(low, 0.0));
    }
    return worked;
  }

  /// Straight, parallel to the AB line and in a cell, where no swath works.
  void is_no_swath(const HeadlandPassRecord& pass, const std::vector<Point>& line) {
    constexpr double kParallel_m = 0.02;
    constexpr double kMost = 0.5;
    const auto ab = std::ranges::find(plan_.plan.ab_lines, ground_.block, &AbRecord::block);
    if (line.size() != 2 || ab == plan_.plan.ab_lines.end()) return;
    const Point along = unit(heading_rad(plan_.plane.to_local(ab->b) - plan_.plane.to_local(ab->a)));
    if (std::abs(cross(along, line[1] - line[0])) > kParallel_m) return;
    const double length = distance_m(line[0], line[1]);
    const double within = perimeter_m(common(line_through(line), cells_));
    const Point ahead = unit(heading_rad(line[1] - line[0]));
    if (within >= kMost * length && worked_by_swaths_m(line[0], ahead, length) < kMost * length)
      plan_.findings.add(
          "line_kind", ground_.block, line.front(), {within, 0},
          "headland pass " + pass.id + " lies in a cell, parallel to the AB line: it is a swath");
  }

  Case& plan_;
  const Ground& ground_;
  const HeadlandRecord& headland_;
  Shape cells_;
};

}  // namespace

void check_headlands(Case& plan) {
  for (const Ground& ground : plan.grounds) {
    const auto of_block = [&](const auto& record) { return record.block == ground.block; };
    const auto count = std::ranges::count_if(plan.plan.headlands, of_block);
    const auto headland = std::ranges::find_if(plan.plan.headlands, of_block);
    const bool passes = std::ranges::any_of(plan.plan.headland_passes, of_block);
    if (passes && plan.vehicle.work.headland_order == "none")
      plan.findings.add("headland", ground.block, std::nullopt, {},
                        "the block has headland passes; the job has its headland left unworked");
    if (count > 1 || (count == 0 && passes))
      plan.findings.add("headland", ground.block, std::nullopt, {1.0 * static_cast<double>(count), 1},
                        "the block has headland passes and no headland, or several headlands");
    else if (count == 1)
      HeadlandCheck{plan, ground, *headland}.run();
  }
}

}  // namespace selion::verifying
