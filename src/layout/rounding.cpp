// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "corner_line.hpp"
#include "corner_shape.hpp"
#include "selion/core/angle.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

constexpr int kMostRepairs = 60;
constexpr double kLeastRun = 1;  // of the working width: shorter runs are not worth a pass

/// Straight stretches that lie in one line put together again.
Path straightened(const Path& path) {
  Path out;
  for (const Stretch& stretch : path) {
    const bool line_on = !out.empty() && is_straight(out.back().curve) && is_straight(stretch.curve) &&
                         std::abs(wrapped(out.back().curve.heading_rad - stretch.curve.heading_rad)) < 1e-12;
    if (line_on)
      out.back().curve.length_m += stretch.curve.length_m;
    else
      out.push_back(stretch);
  }
  return out;
}

/// The line from a to b in steps short enough that a run ends close to what it cannot pass.
std::vector<Path> steps_along(Point a, Point b) {
  constexpr double kStep_m = 0.5;
  const int count = std::max(1, static_cast<int>(std::ceil(distance_m(a, b) / kStep_m)));
  const Point step = (1.0 / count) * (b - a);
  std::vector<Path> steps;
  steps.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    steps.push_back({{line(a + static_cast<double>(k) * step, a + (k + 1.0) * step), Gear::forward}});
  return steps;
}

bool holds(const Ground& ground, const Path& step) { return fits(ground.space, ground.footprint, step); }

/// What can be driven of the steps without a gap, where that is worth a pass.
std::vector<HeadlandRun> runs_of(const Ground& ground, const std::vector<Path>& steps) {
  std::vector<HeadlandRun> runs;
  Path run;
  const auto close = [&] {
    if (length_m(run) >= kLeastRun * ground.machine.working_width_m)
      runs.push_back({straightened(run), false});
    run.clear();
  };
  for (const Path& step : steps) {
    if (holds(ground, step))
      append(run, step);
    else
      close();
  }
  close();
  return runs;
}

/// A ring that is not to be driven round, as chains of edges: joined by tight corners where they have the
/// room and fit, parted at all others.
class Chains {
 public:
  Chains(const Ground& ground, const Ring& ring, double room_m) : ground_{ground}, room_m_{room_m} {
    const double most = 1 / ground.machine.min_work_radius_m.value_or(1e-9);
    tight_ = limits_at(ground.machine, ground.machine.turn_speed_mps);
    tight_.curvature_per_m = std::min(tight_.curvature_per_m, most);
    const auto sharpest = std::max_element(ring.begin(), ring.end(), [&](const Point& a, const Point& b) {
      return std::abs(turn_at(ring, &a - ring.data())) < std::abs(turn_at(ring, &b - ring.data()));
    });
    line_.assign(sharpest, ring.end());
    line_.insert(line_.end(), ring.begin(), sharpest);
    line_.push_back(line_.front());
  }

  /// From the sharpest corner once round.
  std::vector<HeadlandRun> runs() {
    Point from = line_.front();
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const auto bend = i + 1 < line_.size() ? bend_at(i, from) : std::nullopt;
      const Point to = bend ? bend->front().curve.start : line_[i];
      for (Path& step : steps_along(from, to)) steps_.push_back(std::move(step));
      if (bend)
        steps_.push_back(*bend);
      else
        close();
      from = bend ? end_pose(*bend).at : line_[i];
    }
    return std::move(runs_);
  }

 private:
  static double turn_at(const Ring& ring, std::ptrdiff_t at) {
    const auto i = static_cast<std::size_t>(at);
    const Point before = ring[(i + ring.size() - 1) % ring.size()];
    const Point after = ring[(i + 1) % ring.size()];
    return wrapped(heading_rad(after - ring[i]) - heading_rad(ring[i] - before));
  }

  /// At the end of an edge that is begun at `from`; half of the next edge is left to its other end.
  [[nodiscard]] std::optional<Path> bend_at(std::size_t i, Point from) const {
    constexpr double kSharpest_rad = 1.2;
    const double in = heading_rad(line_[i] - line_[i - 1]);
    const double turn = wrapped(heading_rad(line_[i + 1] - line_[i]) - in);
    if (std::abs(turn) > kSharpest_rad) return std::nullopt;
    const CornerShape shape = shape_within(turn, tight_, ground_.footprint, room_m_);
    const CornerReach reach = reach_of(turn, shape);
    if (reach.before_m > distance_m(from, line_[i]) || reach.after_m > distance_m(line_[i], line_[i + 1]) / 2)
      return std::nullopt;
    Path bend = corner_path({line_[i] - reach.before_m * unit(in), in}, turn, shape);
    return holds(ground_, bend) ? std::optional{std::move(bend)} : std::nullopt;
  }

  void close() {
    for (HeadlandRun& run : runs_of(ground_, steps_)) runs_.push_back(std::move(run));
    steps_.clear();
  }

  const Ground& ground_;
  double room_m_;
  CurveLimits tight_;
  Ring line_;
  std::vector<Path> steps_;
  std::vector<HeadlandRun> runs_;
};

std::vector<HeadlandRun> runs_on_edges(const Ground& ground, const Ring& ring, double room_m) {
  if (ring.size() < 3) return {};
  return Chains{ground, ring, room_m}.runs();
}

/// Repairs until all fits.
std::vector<HeadlandRun> runs_along(const Ground& ground, const Ring& ring, double room_m, double stray_m) {
  CornerLine corners{ground, ring, room_m, stray_m};
  bool moved = true;
  for (int round = 0; moved && round < kMostRepairs; ++round) {
    if (!corners.make_room()) return runs_on_edges(ground, simplified(ring, stray_m), room_m);
    corners.make_gentle();
    moved = corners.repair();
  }
  if (!corners.make_room()) return runs_on_edges(ground, simplified(ring, stray_m), room_m);
  if (!moved && corners.fits()) return {{corners.path(), true}};
  return corners.fitting_runs();
}

}  // namespace

bool CornerLine::fits() const { return holds(ground_, path()); }

std::vector<HeadlandRun> CornerLine::fitting_runs() const {
  std::vector<Path> steps;
  Index i = first_;
  for (std::size_t k = 0; k < count_; ++k, i = next(i)) {
    for (const Stretch& whole : edge_path(i))
      for (Path& step : steps_along(whole.curve.start, end_of(whole.curve).at))
        steps.push_back(std::move(step));
    steps.push_back(corner_at(next(i)));
  }
  const auto gap =
      std::find_if_not(steps.begin(), steps.end(), [this](const Path& step) { return holds(ground_, step); });
  std::rotate(steps.begin(), gap, steps.end());  // so that no run crosses the seam
  return runs_of(ground_, steps);
}

namespace {

/// The runs that are longest and fewest: of each, a width counts as lost.
class Longest {
 public:
  explicit Longest(const Ground& ground) : width_m_{ground.machine.working_width_m} {}

  void offer(std::vector<HeadlandRun> runs) {
    double worth_m = 0;
    for (const HeadlandRun& run : runs) worth_m += length_m(run.path) - width_m_;
    if (worth_m <= worth_m_) return;
    worth_m_ = worth_m;
    runs_ = std::move(runs);
  }
  [[nodiscard]] std::vector<HeadlandRun> runs() && { return std::move(runs_); }

 private:
  double width_m_;
  double worth_m_ = 0;
  std::vector<HeadlandRun> runs_;
};

}  // namespace

/// Where the ring itself leads nowhere round, by lines that stray further: noise of the border is no way. A
/// loop that leaves much of the ring out, as in a band in which it turns too early, has to work more than
/// runs along the sides would.
std::vector<HeadlandRun> drivable_along(const Ground& ground, const Ring& ring, double room_m) {
  constexpr double kAllRound = 0.8;
  Longest longest{ground};
  for (const double stray_m : {kFollow_m, 5 * kFollow_m, 20 * kFollow_m}) {
    std::vector<HeadlandRun> runs = runs_along(ground, ring, room_m, stray_m);
    const bool loop = runs.size() == 1 && runs.front().closed;
    if (loop && length_m(runs.front().path) >= kAllRound * perimeter_m(Polygon{ring, {}})) return runs;
    longest.offer(std::move(runs));
    if (loop) longest.offer(runs_on_edges(ground, simplified(ring, stray_m), room_m));
  }
  return std::move(longest).runs();
}

}  // namespace selion
