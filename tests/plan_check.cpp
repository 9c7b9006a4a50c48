// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include <proj.h>

namespace selion {
namespace {

constexpr double kInside_m = 0.01;
constexpr double kSlack = 1 + 1e-6;  // what rounding may exceed a limit by
constexpr double kNear_m =
    2e-5;  // of two samples within 0.1 ms one is left out: the speeds then lead elsewhere

struct State {
  Point at;
  double heading_rad;
  double curvature_per_m;
};

/// Simpson's rule over steps of a decimetre: nothing is shared with the planner's curves.
State state_of(const PieceRecord& piece, double s_m) {
  const auto angle = [&](double s) {
    return piece.heading_rad + piece.curvature_per_m * s + piece.sharpness_per_m2 * s * s / 2;
  };
  Point at{piece.x_m, piece.y_m};
  const bool straight = piece.curvature_per_m == 0 && piece.sharpness_per_m2 == 0;
  const int steps = straight ? 1 : std::max(1, static_cast<int>(std::ceil(s_m / 0.1)));
  const double h = s_m / steps;
  for (int i = 0; i < steps; ++i) {
    const double a = angle(i * h), m = angle((i + 0.5) * h), b = angle((i + 1) * h);
    at.x_m += h / 6 * (std::cos(a) + 4 * std::cos(m) + std::cos(b));
    at.y_m += h / 6 * (std::sin(a) + 4 * std::sin(m) + std::sin(b));
  }
  return {at, angle(s_m), piece.curvature_per_m + piece.sharpness_per_m2 * s_m};
}

class Projection {
 public:
  explicit Projection(const std::string& proj)
      : transform_{
            proj_create_crs_to_crs(PJ_DEFAULT_CTX, "OGC:CRS84", (proj + " +type=crs").c_str(), nullptr),
            proj_destroy} {}
  [[nodiscard]] Point operator()(LonLat p) const {
    const PJ_COORD out = proj_trans(transform_.get(), PJ_FWD, proj_coord(p.lon_deg, p.lat_deg, 0, 0));
    return {out.xy.x, out.xy.y};
  }

 private:
  std::unique_ptr<PJ, PJ* (*)(PJ*)> transform_;
};

struct Area {
  std::vector<std::vector<Point>> rings;

  [[nodiscard]] bool holds(Point p) const {
    bool inside = false;
    for (const auto& ring : rings)
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        if ((ring[i].y_m > p.y_m) != (ring[j].y_m > p.y_m) &&
            p.x_m < (ring[j].x_m - ring[i].x_m) * (p.y_m - ring[i].y_m) / (ring[j].y_m - ring[i].y_m) +
                        ring[i].x_m)
          inside = !inside;
    return inside;
  }
  [[nodiscard]] double to_border_m(Point p) const {
    double least = 1e9;
    for (const auto& ring : rings)
      for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Point along = ring[i] - ring[j];
        const double square = dot(along, along);
        const double t = square > 0 ? std::clamp(dot(p - ring[j], along) / square, 0.0, 1.0) : 0.0;
        least = std::min(least, distance_m(p, ring[j] + t * along));
      }
    return least;
  }
};

std::string place(const TrajectoryRecord& t, std::size_t piece) {
  return "block " + std::to_string(t.block) + " piece " + std::to_string(piece) + " (" +
         t.pieces[piece].kind + " " + t.pieces[piece].ref + "): ";
}

class Check {
 public:
  Check(const Plan& plan, const Machine& machine) : plan_{plan}, machine_{machine} {
    const Projection projection{plan.file.proj};
    for (const LonLatArea& part : plan.file.fields.at(0).parts) {
      Area area;
      const auto add = [&](const LonLatLine& line) {
        area.rings.emplace_back();
        for (const LonLat p : line) area.rings.back().push_back(projection(p));
      };
      add(part.shell);
      for (const LonLatLine& hole : part.holes) add(hole);
      areas_.push_back(std::move(area));
    }
  }

  std::vector<std::string> run() {
    for (const TrajectoryRecord& t : plan_.file.trajectories) {
      joints(t);
      pivots(t);
      limits(t);
      inside(t);
      times(t);
      samples(t);
      driving(t);
    }
    once();
    return std::move(faults_);
  }

 private:
  void say(const std::string& text) {
    if (faults_.size() < 20) faults_.push_back(text);
  }

  [[nodiscard]] static bool stands(const PieceRecord& p) { return p.kind == "wait" || p.kind == "pivot"; }

  void joints(const TrajectoryRecord& t) {
    for (std::size_t i = 1; i < t.pieces.size(); ++i) {
      const PieceRecord& a = t.pieces[i - 1];
      const PieceRecord& b = t.pieces[i];
      const State end = state_of(a, a.length_m);
      if (distance_m(end.at, {b.x_m, b.y_m}) > 1e-6)
        say(place(t, i) + "starts off the end of the one before");
      const double turn = end.heading_rad + a.angle_rad.value_or(0) - b.heading_rad +
                          (a.gear == b.gear ? 0 : std::acos(-1.0));
      if (std::abs(std::remainder(turn, 2 * std::acos(-1.0))) > 1e-6) say(place(t, i) + "heading jumps");
      const bool rest = a.gear != b.gear || stands(a) || stands(b);
      if (!rest && std::abs(end.curvature_per_m - b.curvature_per_m) > 1e-6)
        say(place(t, i) + "curvature jumps");
    }
  }

  void limits(const TrajectoryRecord& t) {
    const double most = max_curvature_per_m(machine_) * (1 + 1e-6);
    const double most_down =
        machine_.min_work_radius_m ? std::min(most, (1 + 1e-6) / *machine_.min_work_radius_m) : most;
    for (std::size_t i = 0; i < t.pieces.size(); ++i) {
      const PieceRecord& p = t.pieces[i];
      const double tightest =
          std::max(std::abs(p.curvature_per_m), std::abs(state_of(p, p.length_m).curvature_per_m));
      if (tightest > (p.tool == 1 ? most_down : most)) say(place(t, i) + "too tight");
    }
  }

  void pivots(const TrajectoryRecord& t) {
    const Projection projection{plan_.file.proj};
    std::vector<Point> at;
    for (const LonLat lonlat : t.line) at.push_back(projection(lonlat));
    std::size_t sample = 0;
    for (std::size_t i = 0; i < t.pieces.size(); ++i) {
      const PieceRecord& p = t.pieces[i];
      if (p.kind != "pivot") {
        if (p.angle_rad) say(place(t, i) + "has an angle");
        continue;
      }
      if (!p.angle_rad || !p.duration_s) {
        say(place(t, i) + "has no angle or time");
        continue;
      }
      if (machine_.kind != MachineKind::differential || !machine_.may_pivot)
        say(place(t, i) + "the machine may not pivot");
      if (p.length_m != 0 || p.tool != 0) say(place(t, i) + "moves on or has its tool down");
      if (*p.duration_s < least_pivot_s(*p.angle_rad) - 1e-4) say(place(t, i) + "rotates too fast");
      if (!rotates(t, at, p, sample)) say(place(t, i) + "the samples do not rotate with it");
    }
  }

  /// The wheels of both sides from rest to rest over their way.
  [[nodiscard]] double least_pivot_s(double angle_rad) const {
    const double way = std::abs(angle_rad) * machine_.track_m / 2;
    const double slow = 1 / machine_.max_accel_mps2 + 1 / machine_.max_brake_mps2;
    const double speed = machine_.turn_speed_mps;
    return way < speed * speed * slow / 2 ? std::sqrt(2 * way * slow) : way / speed + speed * slow / 2;
  }

  /// From `sample` on, one that stands there with the heading before, and one with that after, as much later
  /// as the piece says.
  [[nodiscard]] static bool rotates(const TrajectoryRecord& t, const std::vector<Point>& at,
                                    const PieceRecord& p, std::size_t& sample) {
    const auto stands_at = [&](std::size_t i, double heading) {
      const double points = heading + (p.gear > 0 ? 0 : std::acos(-1.0));
      const double off = std::remainder(t.heading_rad[i] - points, 2 * std::acos(-1.0));
      return std::abs(off) < 1e-6 && t.speed_mps[i] == 0 && distance_m(at[i], {p.x_m, p.y_m}) < 2e-3;
    };
    for (std::size_t from = sample; from < at.size(); ++from) {
      if (!stands_at(from, p.heading_rad)) continue;
      for (std::size_t to = from + 1; to < at.size() && t.t_s[to] - t.t_s[from] < *p.duration_s + 2e-4; ++to)
        if (t.t_s[to] - t.t_s[from] > *p.duration_s - 2e-4 && stands_at(to, p.heading_rad + *p.angle_rad)) {
          sample = to;
          return true;
        }
    }
    return false;
  }

  /// Body corners and tool ends every degree of a pivot, every 0.1 m on curves and 2 m on lines, by the
  /// block's own area.
  void inside(const TrajectoryRecord& t) {
    const Area& area = areas_.at(static_cast<std::size_t>(t.block) - 1);
    for (std::size_t i = 0; i < t.pieces.size(); ++i) {
      const PieceRecord& p = t.pieces[i];
      const double step = p.curvature_per_m == 0 && p.sharpness_per_m2 == 0 ? 2.0 : 0.1;
      const double angle = p.angle_rad.value_or(0);
      const int steps = std::max(
          {1, static_cast<int>(std::ceil(p.length_m / step)), static_cast<int>(std::abs(angle) * 57)});
      for (int k = 0; k <= steps; ++k) {
        const State s = state_of(p, p.length_m * k / steps);
        const Pose pose{s.at, s.heading_rad + angle * k / steps + (p.gear > 0 ? 0 : std::acos(-1.0))};
        if (!area.holds(s.at)) return say(place(t, i) + "the path leaves the field");
        const double out_m = outside_m(area, pose);
        if (out_m > kInside_m)
          return say(place(t, i) + "body or tool is " + std::to_string(out_m) + " m out of the field at " +
                     std::to_string(s.at.x_m) + ", " + std::to_string(s.at.y_m));
      }
    }
  }

  /// How far a corner of body or tool lies outside, or a corner of the border inside the body.
  [[nodiscard]] double outside_m(const Area& area, const Pose& pose) const {
    double most = 0;
    for (const Point corner : corners_)
      if (const Point p = placed(pose, corner); !area.holds(p)) most = std::max(most, area.to_border_m(p));
    const Point ahead = unit(pose.heading_rad);
    for (const auto& ring : area.rings)
      for (const Point p : ring) {
        const double x = dot(p - pose.at, ahead);
        const double y = cross(ahead, p - pose.at);
        most = std::max(most, std::min({machine_.front_m - x, x + machine_.rear_m,
                                        machine_.body_width_m / 2 - std::abs(y)}));
      }
    return most;
  }

  void times(const TrajectoryRecord& t) {
    for (std::size_t i = 1; i < t.t_s.size(); ++i)
      if (std::llround(t.t_s[i] * 1e4) <= std::llround(t.t_s[i - 1] * 1e4))  // as the file writes them
        return say("time stands still at sample " + std::to_string(i));
  }

  /// A sample stands at the end of every piece, in order.
  void samples(const TrajectoryRecord& t) {
    const Projection projection{plan_.file.proj};
    std::size_t piece = 0;
    const auto ends_at = [&](Point at) {
      const State end = state_of(t.pieces[piece], t.pieces[piece].length_m);
      return distance_m(end.at, at) < 2e-3;
    };
    for (std::size_t i = 0; i < t.line.size(); ++i) {
      const Point at = projection(t.line[i]);
      while (piece + 1 < t.pieces.size() && ends_at(at)) ++piece;  // pieces below 2 mm share a sample here
    }
    if (piece + 1 != t.pieces.size())
      say("the samples pass only " + std::to_string(piece + 1) + " of " + std::to_string(t.pieces.size()) +
          " pieces");
  }

  /// Limits of driving, between the samples too. Samples and pieces meet by the way driven: the speed's
  /// square is linear in it between two samples.
  void driving(const TrajectoryRecord& t) {
    double at_m = 0;     // driven at the sample
    double begin_m = 0;  // driven at the start of the piece
    std::size_t piece = 0;
    for (std::size_t i = 1; i < t.t_s.size(); ++i) {
      const double v0 = std::abs(t.speed_mps[i - 1]), v1 = std::abs(t.speed_mps[i]);
      const double dt = t.t_s[i] - t.t_s[i - 1];
      const double way = (v0 + v1) / 2 * dt;
      const std::string where = "sample " + std::to_string(i) + ": ";
      if ((v1 - v0) / dt > machine_.max_accel_mps2 * kSlack) say(where + "speeds up too fast");
      if ((v0 - v1) / dt > machine_.max_brake_mps2 * kSlack) say(where + "brakes too hard");
      const double gain = way > 0 ? (v1 * v1 - v0 * v0) / way : 0;
      for (double from = at_m; way > 0 && piece < t.pieces.size();) {
        const double end_m = begin_m + t.pieces[piece].length_m;
        const double to = std::min(end_m, at_m + way);
        if (to - from > 1e-7)
          between(t, piece, {from - begin_m, to - begin_m, v0 * v0 + gain * (from - at_m), gain});
        if (end_m > at_m + way) break;
        from = to;
        begin_m = end_m;
        ++piece;
      }
      at_m += way;
      const double end_m = piece < t.pieces.size() ? begin_m + t.pieces[piece].length_m : begin_m;
      if (std::abs(at_m - begin_m) < kNear_m) at_m = begin_m;
      if (std::abs(at_m - end_m) < kNear_m) at_m = end_m;
    }
    if (std::abs(at_m - t.length_m) > 1e-4)
      say("the speeds lead " + std::to_string(at_m - t.length_m) + " m beyond the end");
  }

  /// A part of a piece driven with the square of the speed `speed2` at its start, growing by `gain` a metre.
  struct Part {
    double from_m;
    double to_m;
    double speed2;
    double gain;

    [[nodiscard]] double speed2_at(double s_m) const { return std::max(0.0, speed2 + gain * (s_m - from_m)); }
  };

  void between(const TrajectoryRecord& t, std::size_t i, const Part& part) {
    const PieceRecord& p = t.pieces[i];
    const double slack = slack_of(t, i);
    const double v2 = std::max(part.speed2_at(part.from_m), part.speed2_at(part.to_m));
    const bool bends = p.curvature_per_m != 0 || p.sharpness_per_m2 != 0;
    const double cap = p.tool == 1 ? machine_.work_speed_mps
                       : bends     ? machine_.turn_speed_mps
                                   : machine_.max_speed_mps;
    if (std::sqrt(v2) > cap * slack) say(place(t, i) + "too fast: " + std::to_string(std::sqrt(v2)) + " m/s");
    if (most_lateral(p, part) > machine_.max_lateral_mps2 * slack)
      say(place(t, i) + "too fast for its curvature");
    if (least_room(p, part, slack) < 0) say(place(t, i) + "steers too fast");
  }

  /// Of two samples within the file's 0.1 ms one is left out, and a corner of the speed with it: beside
  /// pieces driven as quickly as that, speeds are off by an acceleration for that time.
  [[nodiscard]] static double slack_of(const TrajectoryRecord& t, std::size_t i) {
    constexpr double kQuick_m = 5e-4;
    for (std::size_t k = i == 0 ? 0 : i - 1; k < t.pieces.size() && k <= i + 1; ++k)
      if (t.pieces[k].length_m < kQuick_m && !stands(t.pieces[k])) return 1 + 2e-4;
    return kSlack;
  }

  /// v^2 |k|: a parabola, largest at an end or at its vertex.
  [[nodiscard]] static double most_lateral(const PieceRecord& p, const Part& part) {
    const auto lateral = [&](double s) {
      return part.speed2_at(s) * std::abs(p.curvature_per_m + p.sharpness_per_m2 * s);
    };
    const double bend = part.gain * p.sharpness_per_m2;
    double most = std::max(lateral(part.from_m), lateral(part.to_m));
    if (bend != 0) {
      const double start2 = part.speed2 - part.gain * part.from_m;
      const double vertex = -(start2 * p.sharpness_per_m2 + part.gain * p.curvature_per_m) / (2 * bend);
      most = std::max(most, lateral(std::clamp(vertex, part.from_m, part.to_m)));
    }
    return most;
  }

  /// The square of the speed at which the wheels turn as fast as they can, less that of the speed: convex
  /// along the piece, so its least lies where its derivative, which only rises, changes sign.
  [[nodiscard]] double least_room(const PieceRecord& p, const Part& part, double slack) const {
    if (p.sharpness_per_m2 == 0) return 0;
    const bool car = machine_.kind == MachineKind::car;
    const double base = car ? machine_.wheelbase_m : machine_.track_m;
    const double straight =
        machine_.max_steer_rate_deg_s * std::acos(-1.0) / 180 / (base * std::abs(p.sharpness_per_m2)) * slack;
    const auto x = [&](double s) { return car ? base * (p.curvature_per_m + p.sharpness_per_m2 * s) : 0; };
    const auto room = [&](double s) { return std::pow(straight * (1 + x(s) * x(s)), 2) - part.speed2_at(s); };
    double low = part.from_m, high = part.to_m;
    for (int i = 0; i < 50; ++i) {
      const double s = (low + high) / 2;
      const double rise =
          straight * straight * 4 * x(s) * (1 + x(s) * x(s)) * base * p.sharpness_per_m2 - part.gain;
      (rise < 0 ? low : high) = s;
    }
    return std::min({room(part.from_m), room(part.to_m), room(low)});
  }

  void once() {
    std::map<std::pair<int, std::string>, int> driven;
    for (const TrajectoryRecord& t : plan_.file.trajectories) {
      std::string last;
      for (const PieceRecord& p : t.pieces) {
        if (!p.ref.empty() && p.ref != last) ++driven[{t.block, p.ref}];
        if (p.kind == "wait") continue;
        last = p.ref;
        if ((p.tool == 1) != (p.kind == "swath" || p.kind == "headland_pass"))
          say("the tool is down in a " + p.kind);
        if (p.tool == 1 && p.gear < 0) say("the tool is down in reverse");
      }
    }
    for (const SwathRecord& swath : plan_.file.swaths) driven_once(driven, swath.block, swath.id);
    for (const HeadlandPassRecord& pass : plan_.file.headland_passes)
      driven_once(driven, pass.block, pass.id);
    for (const auto& [piece, times] : driven) say(piece.second + " is driven, but the plan has no such line");
  }

  void driven_once(std::map<std::pair<int, std::string>, int>& driven, int block, const std::string& id) {
    const auto found = driven.find({block, id});
    if (found == driven.end() || found->second != 1)
      say(id + " is driven " + std::to_string(found == driven.end() ? 0 : found->second) + " times");
    if (found != driven.end()) driven.erase(found);
  }

  const Plan& plan_;
  const Machine& machine_;
  std::vector<Area> areas_;
  std::vector<std::string> faults_;
  std::vector<Point> corners_{
      {machine_.front_m, machine_.body_width_m / 2},     {machine_.front_m, -machine_.body_width_m / 2},
      {-machine_.rear_m, machine_.body_width_m / 2},     {-machine_.rear_m, -machine_.body_width_m / 2},
      {machine_.tool_x_m, machine_.working_width_m / 2}, {machine_.tool_x_m, -machine_.working_width_m / 2},
      {machine_.tool_x_m, machine_.working_width_m / 4}, {machine_.tool_x_m, -machine_.working_width_m / 4}};
};

}  // namespace

std::vector<std::string> faults_of(const Plan& plan, const Machine& machine) {
  return Check{plan, machine}.run();
}

}  // namespace selion
