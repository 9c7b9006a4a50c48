// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "corner_line.hpp"
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

/// Where no way leads round: each edge for itself.
std::vector<HeadlandRun> runs_on_edges(const Ground& ground, const Ring& ring) {
  std::vector<HeadlandRun> runs;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (distance_m(ring[j], ring[i]) < kLeastRun * ground.machine.working_width_m) continue;
    for (HeadlandRun& run : runs_of(ground, steps_along(ring[j], ring[i]))) runs.push_back(std::move(run));
  }
  return runs;
}

/// Repairs until all fits.
std::vector<HeadlandRun> runs_along(const Ground& ground, const Ring& ring, double room_m, double stray_m) {
  CornerLine corners{ground, ring, room_m, stray_m};
  bool moved = true;
  for (int round = 0; moved && round < kMostRepairs; ++round) {
    if (!corners.make_room()) return runs_on_edges(ground, simplified(ring, stray_m));
    corners.make_gentle();
    moved = corners.repair();
  }
  if (!corners.make_room()) return runs_on_edges(ground, simplified(ring, stray_m));
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

/// Where the ring itself leads nowhere round, by lines that stray further: noise of the border is no way.
std::vector<HeadlandRun> drivable_along(const Ground& ground, const Ring& ring, double room_m) {
  std::vector<HeadlandRun> first;
  for (const double stray_m : {kFollow_m, 5 * kFollow_m, 20 * kFollow_m}) {
    std::vector<HeadlandRun> runs = runs_along(ground, ring, room_m, stray_m);
    if (runs.size() == 1 && runs.front().closed) return runs;
    if (first.empty()) first = std::move(runs);
  }
  return first;
}

}  // namespace selion
