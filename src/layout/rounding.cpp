// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parts.hpp"
#include "selion/core/angle.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

constexpr double kFollow_m = 0.02;  // how far the corner line may stray from the ring
constexpr double kShortestEdge_m = 0.02;
constexpr double kSharpest_rad = 2.6;  // a corner of the line turning more than this is cut off
constexpr double kPush_m = 0.15;       // how far a corner that does not fit moves at a time
constexpr int kMostRepairs = 60;
constexpr double kGentleCut_m =
    0.05;  // a corner may be driven at working speed if that cuts no more than this

constexpr double kLeastRun = 1;  // of the working width: shorter runs are not worth a pass

bool is_line(const Curve& curve) { return curve.curvature_per_m == 0 && curve.sharpness_per_m2 == 0; }

struct Vertex {
  Point at;
  bool pushed = false;  // swung out already: its neighbours on the edges stand
  double turn_rad = 0;
  double tangent_m = 0;
  CurveLimits limits;
};

/// Straight stretches that lie in one line put together again.
Path straightened(const Path& path) {
  Path out;
  for (const Stretch& stretch : path) {
    const bool line_on = !out.empty() && is_line(out.back().curve) && is_line(stretch.curve) &&
                         std::abs(wrapped(out.back().curve.heading_rad - stretch.curve.heading_rad)) < 1e-12;
    if (line_on)
      out.back().curve.length_m += stretch.curve.length_m;
    else
      out.push_back(stretch);
  }
  return out;
}

/// A closed line of corners being made drivable.
class CornerLine {
 public:
  CornerLine(const Ground& ground, const Ring& ring) : ground_{ground} {
    const double most = 1 / ground.machine.min_work_radius_m.value_or(1e-9);
    tight_ = limits_at(ground.machine, ground.machine.turn_speed_mps);
    gentle_ = limits_at(ground.machine, ground.machine.work_speed_mps);
    tight_.curvature_per_m = std::min(tight_.curvature_per_m, most);
    gentle_.curvature_per_m = std::min(gentle_.curvature_per_m, most);
    for (const Point p : simplified(ring, kFollow_m)) vertices_.push_back({p, false, 0, 0, tight_});
  }

  /// Merges and drops corners until each has room on its edges. False where nothing is left to drive round.
  bool make_room();
  /// Lets corners that have the room be driven at working speed.
  void make_gentle();
  [[nodiscard]] Path path() const;
  /// Moves what does not fit; false when nothing could be moved.
  bool repair();
  [[nodiscard]] bool fits() const;
  /// The longest runs of edges and corners that fit, where the whole does not.
  [[nodiscard]] std::vector<HeadlandRun> fitting_runs() const;

 private:
  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % vertices_.size(); }
  [[nodiscard]] std::size_t previous(std::size_t i) const {
    return (i + vertices_.size() - 1) % vertices_.size();
  }
  [[nodiscard]] Point edge(std::size_t i) const { return vertices_[next(i)].at - vertices_[i].at; }
  [[nodiscard]] double room_m(std::size_t i) const {
    return length_m(edge(i)) - vertices_[i].tangent_m - vertices_[next(i)].tangent_m;
  }
  void measure(std::size_t i);
  void measure_all();
  void drop(std::size_t i) { vertices_.erase(vertices_.begin() + static_cast<std::ptrdiff_t>(i)); }
  void relieve(std::size_t i);
  [[nodiscard]] std::optional<std::size_t> tightest_edge() const;
  bool merge(std::size_t i);
  [[nodiscard]] Path corner_path(std::size_t i) const;
  [[nodiscard]] Path edge_path(std::size_t i) const;
  [[nodiscard]] std::vector<Path> edge_steps(std::size_t i) const;
  void chamfer(std::size_t i, std::vector<Vertex>& into) const;
  void swing_out(std::size_t i, std::vector<Vertex>& into) const;

  const Ground& ground_;
  CurveLimits tight_;
  CurveLimits gentle_;
  std::vector<Vertex> vertices_;
};

void CornerLine::measure(std::size_t i) {
  Vertex& v = vertices_[i];
  v.turn_rad = wrapped(heading_rad(edge(i)) - heading_rad(edge(previous(i))));
  v.limits = tight_;
  v.tangent_m = std::abs(v.turn_rad) > kSharpest_rad ? std::numeric_limits<double>::infinity()
                                                     : corner_of(v.turn_rad, tight_).tangent_m;
}

void CornerLine::measure_all() {
  for (std::size_t i = 0; i < vertices_.size(); ++i) measure(i);
}

/// Puts the two ends of edge i into one corner, where the edges beside it meet. Only where both turn the same
/// way.
bool CornerLine::merge(std::size_t i) {
  if (vertices_.size() < 4) return false;
  const std::size_t j = next(i);
  const double sum = vertices_[i].turn_rad + vertices_[j].turn_rad;
  if (vertices_[i].turn_rad * vertices_[j].turn_rad <= 0 || std::abs(sum) > kSharpest_rad) return false;
  const Point before = edge(previous(i));
  const Point after = edge(j);
  const double across = cross(before, after);
  if (std::abs(across) < 1e-9 * length_m(before) * length_m(after)) return false;
  const double ahead = cross(vertices_[j].at - vertices_[i].at, after) / across;
  if (ahead < 0 || ahead * length_m(before) > 4 * length_m(edge(i)) + 1) return false;
  vertices_[i].at = vertices_[i].at + ahead * before;
  drop(j);
  return true;
}

/// Edge i is too short for the corners at its ends. A left turn may be left out, for that leads inwards.
void CornerLine::relieve(std::size_t i) {
  const std::size_t j = next(i);
  const bool i_too_sharp = std::isinf(vertices_[i].tangent_m);
  if (!i_too_sharp && std::isinf(vertices_[j].tangent_m)) return drop(j);
  if (i_too_sharp || length_m(edge(i)) < kShortestEdge_m) return drop(i);
  if (merge(i)) return;
  const bool i_left = vertices_[i].turn_rad > 0;
  const bool j_left = vertices_[j].turn_rad > 0;
  if (i_left != j_left) return drop(i_left ? i : j);
  drop(std::abs(vertices_[i].turn_rad) < std::abs(vertices_[j].turn_rad) ? i : j);
}

/// The edge that lacks the most room, if any does.
std::optional<std::size_t> CornerLine::tightest_edge() const {
  std::optional<std::size_t> tightest;
  double least_m = 0;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const double room = length_m(edge(i)) < kShortestEdge_m ? -std::numeric_limits<double>::max() : room_m(i);
    if (room >= least_m) continue;
    least_m = room;
    tightest = i;
  }
  return tightest;
}

bool CornerLine::make_room() {
  measure_all();
  while (vertices_.size() >= 3) {
    const auto tightest = tightest_edge();
    if (!tightest) return true;
    relieve(*tightest);
    measure_all();
  }
  return false;
}

void CornerLine::make_gentle() {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    Vertex& v = vertices_[i];
    const Corner corner = corner_of(v.turn_rad, gentle_);
    const double more_m = corner.tangent_m - v.tangent_m;
    if (corner.cut_m > (v.turn_rad > 0 ? kGentleCut_m : kFollow_m / 4)) continue;
    if (room_m(i) < more_m || room_m(previous(i)) < more_m) continue;
    v.tangent_m = corner.tangent_m;
    v.limits = gentle_;
  }
}

Path CornerLine::corner_path(std::size_t i) const {
  const Vertex& v = vertices_[i];
  const double heading = heading_rad(edge(previous(i)));
  return swing({v.at - v.tangent_m * unit(heading), heading}, v.turn_rad, v.limits);
}

Path CornerLine::edge_path(std::size_t i) const {
  constexpr double kNoLine_m = 1e-7;  // below what joints of pieces are held to
  if (room_m(i) < kNoLine_m) return {};
  const Point along = unit(heading_rad(edge(i)));
  const Point a = vertices_[i].at + vertices_[i].tangent_m * along;
  return {{line(a, vertices_[next(i)].at - vertices_[next(i)].tangent_m * along), Gear::forward}};
}

Path CornerLine::path() const {
  Path path;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    append(path, edge_path(i));
    append(path, corner_path(next(i)));
  }
  return path;
}

bool CornerLine::fits() const { return selion::fits(ground_.space, ground_.footprint, path()); }

/// Edge i in steps short enough that a run ends close to what it cannot pass.
std::vector<Path> CornerLine::edge_steps(std::size_t i) const {
  constexpr double kStep_m = 0.5;
  std::vector<Path> steps;
  for (const Stretch& whole : edge_path(i)) {
    const int count = std::max(1, static_cast<int>(std::ceil(whole.curve.length_m / kStep_m)));
    const Point along = (whole.curve.length_m / count) * unit(whole.curve.heading_rad);
    for (int k = 0; k < count; ++k)
      steps.push_back(
          {{line(whole.curve.start + static_cast<double>(k) * along, whole.curve.start + (k + 1.0) * along),
            Gear::forward}});
  }
  return steps;
}

std::vector<HeadlandRun> CornerLine::fitting_runs() const {
  std::vector<Path> steps;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    for (Path& step : edge_steps(i)) steps.push_back(std::move(step));
    steps.push_back(corner_path(next(i)));
  }
  const auto holds = [this](const Path& step) {
    return selion::fits(ground_.space, ground_.footprint, step);
  };
  const auto gap = std::find_if_not(steps.begin(), steps.end(), holds);
  std::rotate(steps.begin(), gap, steps.end());  // so that no run crosses the seam
  std::vector<HeadlandRun> runs;
  Path run;
  const auto close = [&] {
    if (length_m(run) >= kLeastRun * ground_.machine.working_width_m)
      runs.push_back({straightened(run), false});
    run.clear();
  };
  for (const Path& step : steps) {
    if (holds(step))
      append(run, step);
    else
      close();
  }
  close();
  return runs;
}

/// Cuts a left turn off, with room for the two corners that come of it.
void CornerLine::chamfer(std::size_t i, std::vector<Vertex>& into) const {
  const Vertex& v = vertices_[i];
  const double half = v.turn_rad / 2;
  const double wish = std::max(kPush_m, 1.02 * corner_of(half, tight_).tangent_m / std::cos(half));
  const double before = std::min(wish, length_m(edge(previous(i))) / 2);
  const double after = std::min(wish, length_m(edge(i)) / 2);
  into.push_back({v.at - before * unit(heading_rad(edge(previous(i)))), false, 0, 0, tight_});
  into.push_back({v.at + after * unit(heading_rad(edge(i))), false, 0, 0, tight_});
}

/// Moves a right turn away from the border; the edges are left only near it.
void CornerLine::swing_out(std::size_t i, std::vector<Vertex>& into) const {
  const Vertex& v = vertices_[i];
  const Point in = unit(heading_rad(edge(previous(i))));
  const Point out = unit(heading_rad(edge(i)));
  const Point away = left_of(in) + left_of(out);
  const double span = 4 * corner_of(v.turn_rad, tight_).tangent_m + ground_.half_m;
  const double before = std::min(span, length_m(edge(previous(i))) / 2);
  const double after = std::min(span, length_m(edge(i)) / 2);
  if (!v.pushed) into.push_back({v.at - before * in, false, 0, 0, tight_});
  into.push_back({v.at + (kPush_m / std::max(length_m(away), 0.1)) * away, true, 0, 0, tight_});
  if (!v.pushed) into.push_back({v.at + after * out, false, 0, 0, tight_});
}

bool CornerLine::repair() {
  std::vector<Vertex> repaired;
  bool moved = false;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const bool stays = stays_inside(ground_.space, ground_.footprint, corner_path(i)) &&
                       stays_inside(ground_.space, ground_.footprint, edge_path(i)) &&
                       stays_inside(ground_.space, ground_.footprint, edge_path(previous(i)));
    if (stays || std::abs(vertices_[i].turn_rad) < 1e-6) {
      repaired.push_back(vertices_[i]);
      continue;
    }
    moved = true;
    if (vertices_[i].turn_rad > 0)
      chamfer(i, repaired);
    else
      swing_out(i, repaired);
  }
  vertices_ = std::move(repaired);
  return moved;
}

}  // namespace

std::vector<HeadlandRun> drivable_along(const Ground& ground, const Ring& ring) {
  CornerLine corners{ground, ring};
  for (int round = 0; round < kMostRepairs; ++round) {
    if (!corners.make_room()) return {};
    corners.make_gentle();
    if (corners.fits()) return {{corners.path(), true}};
    if (!corners.repair()) break;
  }
  return corners.make_room() ? corners.fitting_runs() : std::vector<HeadlandRun>{};
}

}  // namespace selion
