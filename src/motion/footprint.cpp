// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/motion/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "walk.hpp"

namespace selion {
namespace {

constexpr double kGive_m =
    0.004;  // of the centimetre that "inside" allows; rounding of headland rings takes the rest
constexpr double kStray_m = 0.002;      // of a corner of the body from the chord between two checks
constexpr double kLongestStep_m = 0.5;  // between two checks on a curve
constexpr double kLineStep_m = 8;

/// From x = rear to x = front, `half` to either side.
Corners rectangle(const Stand& stand, double rear_m, double front_m, double half_m) {
  return {stand(rear_m, -half_m), stand(front_m, -half_m), stand(front_m, half_m), stand(rear_m, half_m)};
}

/// Body and tool while the vehicle moves straight from `ahead_m` = 0 to `ahead_m` (negative: backwards).
bool clear_on_line(const FreeSpace& space, const Footprint& f, const Stand& stand, double ahead_m) {
  const double back = std::min(ahead_m, 0.0);
  const double fore = std::max(ahead_m, 0.0);
  return space.clear(rectangle(stand, -f.rear_m + kGive_m + back, f.front_m - kGive_m + fore,
                               f.half_body_m - kGive_m)) &&
         space.clear(rectangle(stand, f.tool_x_m - kGive_m + back, f.tool_x_m + kGive_m + fore,
                               f.half_tool_m - kGive_m));
}

bool clear_at(const FreeSpace& space, const Footprint& f, const Stand& stand) {
  return space.far_from_border(stand.at) || clear_on_line(space, f, stand, 0);
}

bool clear_across(const FreeSpace& space, const Stand& a, const Stand& b, double x_m, double half_m) {
  const Corners swept = swept_across(a, b, x_m, half_m);
  return turns_left(swept) ? space.clear(swept) : space.clear(convex_hull({swept.begin(), swept.end()}));
}

/// Around body and tool at the stand.
Box box_around(const Footprint& f, const Stand& stand) {
  const Point middle = stand((f.front_m - f.rear_m) / 2, 0);
  const double half_length = (f.front_m + f.rear_m) / 2;
  const double cos = std::abs(stand.ahead.x_m);
  const double sin = std::abs(stand.ahead.y_m);
  const Point body{half_length * cos + f.half_body_m * sin, half_length * sin + f.half_body_m * cos};
  const Point line = stand(f.tool_x_m, 0);
  const Point tool{f.half_tool_m * sin, f.half_tool_m * cos};
  return {{std::min(middle.x_m - body.x_m, line.x_m - tool.x_m),
           std::min(middle.y_m - body.y_m, line.y_m - tool.y_m)},
          {std::max(middle.x_m + body.x_m, line.x_m + tool.x_m),
           std::max(middle.y_m + body.y_m, line.y_m + tool.y_m)}};
}

Stand seen_from(const Stand& origin, const Stand& stand) {
  const Point back = mirrored(origin.ahead);
  return {turned(back, stand.at - origin.at), turned(back, stand.ahead)};
}

Box together(const Box& a, const Box& b) {
  return {{std::min(a.low.x_m, b.low.x_m), std::min(a.low.y_m, b.low.y_m)},
          {std::max(a.high.x_m, b.high.x_m), std::max(a.high.y_m, b.high.y_m)}};
}

/// Body and tool at b, and what front, rear and tool sweep from a to b: a spike of the border that enters and
/// leaves between two stands has to cross one of these.
bool clear_between(const FreeSpace& space, const Footprint& f, const Stand& a, const Stand& b) {
  const double half_body = f.half_body_m - kGive_m;
  return space.clear(rectangle(b, -f.rear_m + kGive_m, f.front_m - kGive_m, half_body)) &&
         clear_across(space, a, b, f.tool_x_m, f.half_tool_m - kGive_m) &&
         clear_across(space, a, b, f.front_m - kGive_m, half_body) &&
         clear_across(space, a, b, -f.rear_m + kGive_m, half_body);
}

/// Several stands close together, one step after the other: what is far from the border is told of all at
/// once.
class Steps {
 public:
  static constexpr std::size_t kMost = 4;

  Steps(const Footprint& f, const Stand& first) : footprint_{f} { add(first); }

  [[nodiscard]] bool full() const { return count_ > kMost; }
  void add(const Stand& stand) {
    stands_[count_] = stand;
    boxes_[count_++] = box_around(footprint_, stand);
  }
  [[nodiscard]] bool clear(const FreeSpace& space) const {
    if (space.empty(box(0, count_)) || space.clear(around())) return true;
    for (std::size_t i = 1; i < count_; ++i)
      if (!space.empty(box(i - 1, i + 1)) && !clear_between(space, footprint_, stands_[i - 1], stands_[i]))
        return false;
    return true;
  }
  /// The next ones begin where these end.
  void begin_anew() {
    stands_[0] = stands_[count_ - 1];
    boxes_[0] = boxes_[count_ - 1];
    count_ = 1;
  }

 private:
  [[nodiscard]] Box box(std::size_t from, std::size_t to) const {
    Box all = boxes_[from];
    for (std::size_t i = from + 1; i < to; ++i) all = together(all, boxes_[i]);
    return all;
  }
  /// A rectangle along the middle stand around all of them: where that is clear, so is what they sweep.
  [[nodiscard]] Corners around() const {
    const Stand& middle = stands_[count_ / 2];
    Box all = box_around(footprint_, seen_from(middle, stands_[0]));
    for (std::size_t i = 1; i < count_; ++i)
      all = together(all, box_around(footprint_, seen_from(middle, stands_[i])));
    return {middle(all.low.x_m, all.low.y_m), middle(all.high.x_m, all.low.y_m),
            middle(all.high.x_m, all.high.y_m), middle(all.low.x_m, all.high.y_m)};
  }

  const Footprint& footprint_;
  std::size_t count_ = 0;
  std::array<Stand, kMost + 1> stands_;
  std::array<Box, kMost + 1> boxes_;
};

/// Nothing near at the start, the middle and the end: with the slack of `free_space` that is nothing near
/// between them.
bool far_along(const FreeSpace& space, const Pose& pose, double ahead_m) {
  const Point step = (ahead_m / 2) * unit(pose.heading_rad);
  return space.far_from_border(pose.at) && space.far_from_border(pose.at + step) &&
         space.far_from_border(pose.at + 2 * step);
}

bool clear_along_line(const FreeSpace& space, const Footprint& f, const Stretch& stretch) {
  const double length = stretch.curve.length_m;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kLineStep_m)));
  const double ahead = length / steps * static_cast<int>(stretch.gear);
  for (int i = 0; i < steps; ++i) {
    const Pose pose = vehicle_pose(stretch, length * i / steps);
    if (!far_along(space, pose, ahead) && !clear_on_line(space, f, Stand{pose}, ahead)) return false;
  }
  return true;
}

/// From `first` over `count` more stands, the i-th of them `stand(i)`, i from 1.
template <class StandAt>
bool clear_by_steps(const FreeSpace& space, const Footprint& f, const Stand& first, int count,
                    StandAt stand) {
  Steps steps{f, first};
  for (int i = 1; i <= count; ++i) {
    steps.add(stand(i));
    if (!steps.full() && i < count) continue;
    if (!steps.clear(space)) return false;
    steps.begin_anew();
  }
  return true;
}

/// The whole circle at once where nothing is near; else from stand to stand.
bool clear_around(const FreeSpace& space, const Footprint& f, const Stretch& pivot) {
  const Pose from = vehicle_pose(pivot, 0);
  if (space.far_from_border(from.at)) return true;
  const double step_rad = std::sqrt(8 * kStray_m / reach_m(f));
  const int steps = static_cast<int>(std::ceil(std::abs(pivot.pivot_rad) / step_rad));
  const Stand first{from};
  if (!clear_at(space, f, first)) return false;
  return clear_by_steps(space, f, first, steps, [&](int i) {
    return Stand{{from.at, from.heading_rad + pivot.pivot_rad * i / steps}};
  });
}

bool clear_along(const FreeSpace& space, const Footprint& f, const Stretch& stretch) {
  if (is_pivot(stretch)) return clear_around(space, f, stretch);
  if (is_straight(stretch.curve)) return clear_along_line(space, f, stretch);
  const double length = stretch.curve.length_m;
  const double step_m = std::min(kLongestStep_m, chord_m(stretch.curve, reach_m(f), kStray_m));
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step_m)));
  Walk walk{stretch, steps};
  const Stand first = walk.here();
  if (!clear_at(space, f, first)) return false;
  return clear_by_steps(space, f, first, steps, [&walk](int) {
    walk.advance();
    return walk.here();
  });
}

}  // namespace

Footprint footprint_of(const Machine& machine) {
  return {machine.front_m, machine.rear_m, machine.body_width_m / 2, machine.tool_x_m,
          machine.working_width_m / 2};
}

double reach_m(const Footprint& f) {
  return std::max(std::hypot(std::max(f.front_m, f.rear_m), f.half_body_m),
                  std::hypot(f.tool_x_m, f.half_tool_m));
}

FreeSpace free_space(const Polygon& area, const Footprint& footprint) {
  return {area, reach_m(footprint) + kLineStep_m / 4};
}

/// From the end: what does not fit mostly arrives where it does not. First where stretches begin: most turns
/// that do not fit stand outside at one of these places.
bool stays_inside(const FreeSpace& space, const Footprint& footprint, const Path& path) {
  const auto clear_at_start = [&](const Stretch& s) {
    return clear_at(space, footprint, Stand{vehicle_pose(s, 0)});
  };
  return (path.size() < 3 || std::all_of(path.rbegin(), path.rend() - 1, clear_at_start)) &&
         std::all_of(path.rbegin(), path.rend(),
                     [&](const Stretch& s) { return clear_along(space, footprint, s); });
}

bool fits(const FreeSpace& space, const Footprint& footprint, const Pose& pose) {
  return space.holds(pose.at) && clear_on_line(space, footprint, Stand{pose}, 0);
}

bool fits(const FreeSpace& space, const Footprint& footprint, const Path& path) {
  return path.empty() || (space.holds(path.front().curve.start) && stays_inside(space, footprint, path));
}

}  // namespace selion
