// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_runs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "corner_shape.hpp"
#include "selion/core/angle.hpp"

namespace selion {
namespace {

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

constexpr double kLeastRun = 1;  // of the working width: shorter runs are not worth a pass

bool holds(const Ground& ground, const Path& step) { return fits(ground.space, ground.footprint, step); }

}  // namespace

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

namespace {

/// Of a ring's corners, from the sharpest once round.
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
      const bool turns = bend && !bend->empty();
      for (Path& step : steps_along(from, turns ? bend->front().curve.start : line_[i]))
        steps_.push_back(std::move(step));
      if (turns) steps_.push_back(*bend);
      if (!bend) close();
      from = turns ? end_pose(*bend).at : line_[i];
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

  /// At the end of an edge that is begun at `from`; half of the next edge is left to its other end. Empty
  /// where the next edge leads straight on.
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

}  // namespace

std::vector<HeadlandRun> runs_on_edges(const Ground& ground, const Ring& ring, double room_m) {
  if (ring.size() < 3) return {};
  return Chains{ground, ring, room_m}.runs();
}

}  // namespace selion
