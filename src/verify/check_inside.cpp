// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr int kMostTold = 12;      // faults of a trajectory: each is worked out, few are listed
constexpr int kPlaces = 40;        // of a piece, looked at where it is not clear
constexpr double kFine_m = 0.002;  // a part whose sweep is known as well as this is not halved again

/// A rectangle about the axle, seen along the vehicle.
struct Outline4 {
  double rear_m;
  double front_m;
  double half_m;

  [[nodiscard]] double reach_m() const { return std::max(std::abs(rear_m), std::abs(front_m)); }
};

Corners placed_corners(const Pose& pose, const Outline4& o) {
  const Point ahead = unit(pose.heading_rad);
  const Point left = left_of(ahead);
  const auto corner = [&](double x, double y) { return pose.at + x * ahead + y * left; };
  return {corner(o.rear_m, -o.half_m), corner(o.front_m, -o.half_m), corner(o.front_m, o.half_m),
          corner(o.rear_m, o.half_m)};
}

/// Everything that the rectangle sweeps while the axle moves up to `half_m` either way from the pose and the
/// vehicle turns by up to `turn_rad` either way: it gains so much ahead and so much to the side.
struct Sweep {
  double half_m = 0;
  double turn_rad = 0;
};
Outline4 swept(const Outline4& o, const Sweep& by) {
  const double ahead = by.half_m + by.turn_rad * o.half_m;
  const double aside = by.half_m * by.turn_rad / 2 + by.turn_rad * o.reach_m();
  return {o.rear_m - ahead, o.front_m + ahead, o.half_m + aside};
}

class InsideCheck {
 public:
  InsideCheck(Case& plan, const Driven& driven, const Ground& ground)
      : plan_{plan},
        driven_{driven},
        ground_{ground},
        body_{body_of(plan.vehicle.machine)},
        tool_{tool_of(plan.vehicle.machine)} {}

  void run() {
    for (std::size_t i = 0; i < driven_.pieces.size(); ++i) check(i);
  }

 private:
  static Outline4 body_of(const Machine& m) { return {-m.rear_m, m.front_m, m.body_width_m / 2}; }
  static Outline4 tool_of(const Machine& m) { return {m.tool_x_m, m.tool_x_m, m.working_width_m / 2}; }

  void check(std::size_t i) {
    const PieceLine& piece = driven_.pieces[i];
    if (!ground_.room.holds(piece.spot(0).at)) {
      plan_.findings.add("path_outside", driven_.record->block, piece.spot(0).at, {1, 0},
                         piece_name(driven_, i) + " begins outside the block");
      return;
    }
    const double span = piece.record().angle_rad ? std::abs(*piece.record().angle_rad) : piece.length_m();
    check_shape(i, span, {body_, "body_outside", "body_obstacle", "body"});
    check_shape(i, span, {tool_, "tool_outside", "tool_obstacle", "tool"});
  }

  /// What is to stay inside, and what is said where it does not.
  struct Member {
    Outline4 shape;
    const char* outside;
    const char* in_obstacle;
    const char* name;
  };

  void check_shape(std::size_t i, double span, const Member& member) {
    const int block = driven_.record->block;
    if (plan_.findings.full(member.outside, block) && plan_.findings.full(member.in_obstacle, block)) return;
    if (told_ == kMostTold) return;
    auto where = first_touch(driven_.pieces[i], 0, span, member.shape, ground_.border);
    if (!where && plan_.thin) where = in_thin(*plan_.thin, driven_.pieces[i], span, member.shape);
    if (where) tell(i, span, *where, member);
  }

  /// Of a fence thinner than two centimetres nothing is left less one: the body is less instead. (A tool is a
  /// line, of which there is nothing less.)
  static std::optional<double> in_thin(const Border& thin, const PieceLine& piece, double span,
                                       const Outline4& shape) {
    const Outline4 less{shape.rear_m + kInside_m, shape.front_m - kInside_m, shape.half_m - kInside_m};
    if (!(less.rear_m < less.front_m && less.half_m > 0)) return std::nullopt;
    return first_touch(piece, 0, span, less, thin);
  }

  /// At `along`, metres of the curve, or radians of a pivot.
  static Pose pose(const PieceLine& piece, double along) {
    if (!piece.record().angle_rad) return piece.vehicle(along);
    const Pose start = piece.vehicle(0);
    return {start.at, start.heading_rad + std::copysign(along, *piece.record().angle_rad)};
  }

  static Sweep sweep(const PieceLine& piece, double from, double to) {
    const double half = (to - from) / 2;
    if (piece.record().angle_rad) return {0, half};
    const double bend = std::max(std::abs(piece.curvature_per_m(from)), std::abs(piece.curvature_per_m(to)));
    const double way = half * (1 + std::abs(piece.record().offset_m) * bend);
    return {way, way * bend};
  }

  /// Halves the part until what it sweeps is clear, or known to two millimetres and not clear.
  static std::optional<double> first_touch(const PieceLine& piece, double from, double to,
                                           const Outline4& shape, const Border& border) {
    const double middle = (from + to) / 2;
    const Sweep by = sweep(piece, from, to);
    const Outline4 all = swept(shape, by);
    const Corners corners = placed_corners(pose(piece, middle), all);
    if (border.clear_of(corners)) return std::nullopt;
    if (all.front_m - shape.front_m + all.half_m - shape.half_m < kFine_m)
      return border.touches(corners) ? std::optional{middle} : std::nullopt;
    if (const auto early = first_touch(piece, from, middle, shape, border)) return early;
    return first_touch(piece, middle, to, shape, border);
  }

  /// Around all that the shape may reach on the piece, and what may be nearest to that.
  [[nodiscard]] Box box_around(std::size_t i, double span, const Outline4& shape) const {
    constexpr double kBeside_m = 5;
    const double off = kBeside_m + shape.reach_m() + shape.half_m;
    Box box;
    for (int k = 0; k <= kPlaces; ++k) {
      const Point at = pose(driven_.pieces[i], span * k / kPlaces).at;
      box.take_in(at - Point{off, off});
      box.take_in(at + Point{off, off});
    }
    return box;
  }

  /// How far it gets out, at the worst of some places along the piece.
  void tell(std::size_t i, double span, double first, const Member& member) {
    ++told_;
    double out = 0;
    double worst = first;
    double in_obstacle = 0;
    const Box around = box_around(i, span, member.shape);
    const Shape free = within(ground_.free, around);
    const Shape kept = within(ground_.kept, around);
    for (int k = -1; k <= kPlaces; ++k) {
      const double along = k < 0 ? first : span * k / kPlaces;
      Outline4 some = member.shape;
      if (some.rear_m == some.front_m) some.front_m += 1e-6;  // a line has no area
      const Shape there = polygon_of(placed_corners(pose(driven_.pieces[i], along), some));
      const double off = farthest_m(without(there, free), area_m2(free) > 0 ? free : ground_.free);
      if (off > out) out = off, worst = along;
      in_obstacle = std::max(in_obstacle, area_m2(common(there, kept)));
    }
    const Point at = pose(driven_.pieces[i], worst).at;
    const bool hits = in_obstacle > 1e-6;
    plan_.findings.add(
        hits ? member.in_obstacle : member.outside, driven_.record->block, at, {out, kInside_m},
        "the " + std::string{member.name} + " gets " + shown(out, 3) + " m out of the block" +
            (hits ? ", or nearer to an obstacle than allowed," : "") + " in " + piece_name(driven_, i));
  }

  Case& plan_;
  const Driven& driven_;
  const Ground& ground_;
  Outline4 body_;
  Outline4 tool_;
  int told_ = 0;
};

}  // namespace

void check_inside(Case& plan, const Driven& driven) {
  const Ground* ground = plan.ground(driven.record->block);
  if (ground != nullptr) InsideCheck{plan, driven, *ground}.run();
}

}  // namespace selion::verifying
