// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kStray_m = 0.002;    // of the tool's ends from the chords of what it sweeps
constexpr double kNarrow_m = 0.01;    // on average: rounding between sweeps
constexpr double kMostTurned = -0.5;  // cosine: turned by less than 120 degrees, a strip cannot meet itself

struct ToolLine {
  Point left;
  Point right;
  Point ahead;
};

/// What the tool sweeps: strips, and the sum of their areas step by step.
class Swept {
 public:
  explicit Swept(const Machine& machine) : machine_{machine} {}

  void add(const PieceLine& piece) {
    const double reach = std::hypot(machine_.tool_x_m, machine_.working_width_m / 2);
    const double bend = piece.most_curvature_per_m();
    const double step = std::sqrt(8 * kStray_m / std::max(1e-12, bend * (1 + bend * reach)));
    const int steps = std::max(1, static_cast<int>(std::ceil(piece.length_m() / step)));
    ToolLine from = line(piece.vehicle(0));
    for (int i = 1; i <= steps; ++i) {
      const ToolLine to = line(piece.vehicle(piece.length_m() * i / steps));
      step_between(from, to);
      from = to;
    }
  }
  void end() {
    if (right_.empty()) return;
    std::vector<Point> outline = right_;
    outline.insert(outline.end(), left_.rbegin(), left_.rend());
    Shape strip = polygon_of(outline);
    if (is_valid(strip))
      strips_.push_back(std::move(strip));
    else  // it meets itself: step by step
      for (std::size_t i = 1; i < right_.size(); ++i)
        strips_.push_back(polygon_of(std::array{right_[i - 1], right_[i], left_[i], left_[i - 1]}));
    right_.clear();
    left_.clear();
  }
  [[nodiscard]] const std::vector<Shape>& strips() const { return strips_; }
  [[nodiscard]] double sum_m2() const { return sum_m2_; }

 private:
  [[nodiscard]] ToolLine line(const Pose& pose) const {
    const Point ahead = unit(pose.heading_rad);
    const Point middle = pose.at + machine_.tool_x_m * ahead;
    const Point half = machine_.working_width_m / 2 * left_of(ahead);
    return {middle + half, middle - half, ahead};
  }

  void step_between(const ToolLine& a, const ToolLine& b) {
    const std::array<Point, 4> corners{a.right, b.right, b.left, a.left};
    if (!convex(corners)) {
      end();
      strips_.push_back(convex_hull(corners));  // the inner end goes back
      sum_m2_ += area_m2(strips_.back());
      return;
    }
    sum_m2_ += (cross(corners[2] - corners[0], corners[3] - corners[1])) / 2;
    const bool joined = !right_.empty() && distance_m(right_.back(), a.right) < 1e-3 &&
                        distance_m(left_.back(), a.left) < 1e-3;
    if (!joined) {
      end();
      right_.push_back(a.right);
      left_.push_back(a.left);
      first_ahead_ = b.ahead;
    }
    right_.push_back(b.right);
    left_.push_back(b.left);
    if (dot(first_ahead_, b.ahead) < kMostTurned) end();
  }

  static bool convex(const std::array<Point, 4>& c) {
    for (std::size_t i = 0; i < 4; ++i)
      if (!(cross(c[(i + 1) % 4] - c[i], c[(i + 2) % 4] - c[(i + 1) % 4]) > 0)) return false;
    return true;
  }

  const Machine& machine_;
  std::vector<Shape> strips_;
  std::vector<Point> right_;
  std::vector<Point> left_;
  Point first_ahead_;
  double sum_m2_ = 0;
};

Swept swept_in(const Case& plan, int block) {
  Swept swept{plan.vehicle.machine};
  for (const Driven& driven : plan.drives) {
    if (driven.record->block != block) continue;
    for (const PieceLine& piece : driven.pieces)
      piece.record().tool == 1 && piece.length_m() > 0 ? swept.add(piece) : swept.end();
    swept.end();
  }
  return swept;
}

void add_places(std::vector<VerifiedPlace>& places, const Case& plan, int block, const Shape& shape) {
  const auto to_lonlat = [&plan](const std::vector<Point>& ring) {
    LonLatLine line;
    for (const Point p : ring) line.push_back(plan.plane.to_lonlat(p));
    return line;
  };
  for (const Shape& part : parts_of(shape)) {
    const double area = area_m2(part);
    const auto inside = place_in(part);
    if (area < kNarrow_m / 2 * perimeter_m(part) || !inside) continue;
    const Outline outline = outlines_of(part).front();
    LonLatArea lonlat{to_lonlat(outline.shell), {}};
    for (const auto& hole : outline.holes) lonlat.holes.push_back(to_lonlat(hole));
    places.push_back({block, std::move(lonlat), plan.plane.to_lonlat(*inside), area});
  }
}

/// "Block 2 is only partly planned: 82.9 % of it is covered." Of a block that is not planned: 0.
std::optional<double> told_percent(const std::string& warning, int block) {
  const std::string name = "Block " + std::to_string(block) + " ";
  const std::string partly = name + "is only partly planned: ";
  double percent = 0;
  if (warning.starts_with(name) && warning.find(") is not planned: ") != std::string::npos) return percent;
  if (!warning.starts_with(partly)) return std::nullopt;
  std::from_chars(warning.data() + partly.size(), warning.data() + warning.size(), percent);
  return percent;
}

/// Of a block worked by less than nine tenths a warning says so (docs/plan.md): that is what machine and
/// shape allow. Where work was taken out, none does.
void check_told(Case& plan, int block, double area, double covered) {
  constexpr double kWhole_percent = 90;
  constexpr double kRounding_percent = 0.1;
  const double percent = 100 * covered / area;
  if (percent >= kWhole_percent - kRounding_percent) return;
  const bool is_told = std::ranges::any_of(plan.plan.warnings, [&](const std::string& warning) {
    const auto told = told_percent(warning, block);
    return told && std::abs(*told - percent) <= kRounding_percent;
  });
  if (!is_told)
    plan.findings.add("left_unworked", block, std::nullopt, {percent / 100, kWhole_percent / 100},
                      shown(percent, 1) + " % of the block is worked, and no warning of the plan says so");
}

}  // namespace

void check_coverage(Case& plan, Verdict& verdict) {
  for (const Ground& ground : plan.grounds) {
    const Swept swept = swept_in(plan, ground.block);
    verdict.area_m2 += area_m2(ground.area);
    if (swept.strips().empty()) {
      add_places(verdict.missed, plan, ground.block, ground.area);
      check_told(plan, ground.block, area_m2(ground.area), 0);
      continue;
    }
    const Shape all = dissolved(swept.strips());
    const Shape missed = without(ground.area, all);
    verdict.covered_m2 += area_m2(ground.area) - area_m2(missed);
    verdict.twice_m2 += swept.sum_m2() - area_m2(all);
    check_told(plan, ground.block, area_m2(ground.area), area_m2(ground.area) - area_m2(missed));
    add_places(verdict.missed, plan, ground.block, missed);
  }
}

std::vector<VerifiedPlace> places_worked_twice(const Case& plan) {
  std::vector<VerifiedPlace> places;
  for (const Ground& ground : plan.grounds)
    add_places(places, plan, ground.block, overlaps(swept_in(plan, ground.block).strips()));
  return places;
}

}  // namespace selion::verifying
