// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated_fields.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

namespace selion {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;

/// Numbers of our own making: the standard's distributions differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_{seed} {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 0x1p32;
  }
  int whole(int low, int high) { return low + static_cast<int>(between(0, high - low + 1)); }

 private:
  std::mt19937 engine_;
};

Ring star(Dice& dice, Point middle, double radius_m, double roughness) {
  const int corners = dice.whole(5, 11);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle_rad = kTurn_rad * (i + dice.between(-0.3, 0.3)) / corners;
    ring.push_back(middle + radius_m * dice.between(1 - roughness, 1 + roughness) * unit(angle_rad));
  }
  return ring;
}

Polygon star_field(Dice& dice) { return {star(dice, {}, dice.between(70, 110), 0.35), {}}; }

Polygon l_field(Dice& dice) {
  const double length_m = dice.between(150, 240);
  const double depth_m = dice.between(110, 140);
  const double arm_m = dice.between(55, 90);
  const double low_m = dice.between(45, 65);
  return {{{0, 0}, {length_m, 0}, {length_m, low_m}, {arm_m, low_m}, {arm_m, depth_m}, {0, depth_m}}, {}};
}

/// Teeth of different lengths on a back.
Polygon comb_field(Dice& dice) {
  const int teeth = dice.whole(2, 3);
  Ring ring{{0, 0}};
  double x_m = 0;
  std::vector<Point> top;
  for (int i = 0; i < teeth; ++i) {
    const double tooth_m = dice.between(40, 60);
    const double height_m = dice.between(90, 140);
    top.push_back({x_m, height_m});
    top.push_back({x_m + tooth_m, height_m + dice.between(-8, 8)});
    x_m += tooth_m;
    if (i + 1 == teeth) break;
    const double gap_m = dice.between(15, 30);
    const double floor_m = dice.between(40, 55);
    top.push_back({x_m, floor_m});
    top.push_back({x_m + gap_m, floor_m});
    x_m += gap_m;
  }
  ring.push_back({x_m, 0});
  ring.insert(ring.end(), top.rbegin(), top.rend());
  return {ring, {}};
}

/// Four sides, both ends slanted.
Polygon slanted_field(Dice& dice) {
  const double length_m = dice.between(160, 260);
  const double width_m = dice.between(70, 130);
  const double left_m = dice.between(10, 50);
  const double right_m = dice.between(-50, -10);
  return {{{0, 0}, {length_m, dice.between(4, 12)}, {length_m + right_m, width_m}, {left_m, width_m}}, {}};
}

Ring clockwise(Ring ring) { return {ring.rbegin(), ring.rend()}; }

Polygon field_with_holes(Dice& dice) {
  Polygon area{star(dice, {}, dice.between(95, 120), 0.15), {}};
  const int holes = dice.whole(1, 2);
  for (int i = 0; i < holes; ++i) {
    const Point middle{(i == 0 ? -1 : 1) * dice.between(30, 45), dice.between(-25, 25)};
    area.holes.push_back(clockwise(star(dice, middle, dice.between(5, 14), 0.3)));
  }
  return area;
}

double to_border_m(const Ring& ring, Point p) {
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point side = ring[i] - ring[j];
    const double along = std::clamp(dot(p - ring[j], side) / dot(side, side), 0.0, 1.0);
    least_m = std::min(least_m, distance_m(p, ring[j] + along * side));
  }
  return least_m;
}

struct Shape {
  const char* name;
  Polygon (*make)(Dice& dice);
};

}  // namespace

std::vector<GeneratedField> generated_fields(int count_of_each) {
  constexpr Shape kShapes[] = {{"star", star_field},
                               {"L", l_field},
                               {"comb", comb_field},
                               {"slanted", slanted_field},
                               {"holes", field_with_holes}};
  std::vector<GeneratedField> fields;
  std::uint32_t seed = 0;
  for (const Shape& shape : kShapes) {
    for (int i = 1; i <= count_of_each; ++i) {
      Dice dice{++seed * 7919};
      const Polygon area = shape.make(dice);
      const Point middle = centroid(area);
      const RigidMotion turn{dice.between(0, kTurn_rad), {}};
      fields.push_back({std::string{shape.name} + " " + std::to_string(i),
                        moved(area, [&](Point p) { return turn(p - middle); })});
    }
  }
  return fields;
}

Point deepest_place(const Polygon& area) {
  constexpr double kStep_m = 4;
  const Box box = bounds(area.shell);
  Point best = area.shell.front();
  double most_m = 0;
  for (double x_m = box.low.x_m; x_m < box.high.x_m; x_m += kStep_m) {
    for (double y_m = box.low.y_m; y_m < box.high.y_m; y_m += kStep_m) {
      const Point p{x_m, y_m};
      if (!contains(area, p)) continue;
      double depth_m = to_border_m(area.shell, p);
      for (const Ring& hole : area.holes) depth_m = std::min(depth_m, to_border_m(hole, p));
      if (depth_m > most_m) best = p, most_m = depth_m;
    }
  }
  return best;
}

Point RigidMotion::operator()(Point p) const {
  const Point x = unit(angle_rad);
  return by + p.x_m * x + p.y_m * left_of(x);
}

}  // namespace selion
