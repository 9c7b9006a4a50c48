// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "corner_line.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

constexpr int kMostRepairs = 60;
constexpr double kLeastRun = 1;  // of the working width: shorter runs are not worth a pass

bool is_line(const Curve& curve) { return curve.curvature_per_m == 0 && curve.sharpness_per_m2 == 0; }

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

}  // namespace

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
