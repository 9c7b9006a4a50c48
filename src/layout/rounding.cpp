// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "corner_line.hpp"
#include "open_runs.hpp"
#include "selion/core/angle.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

constexpr int kMostRepairs = 60;

/// Repairs until all fits.
std::vector<HeadlandRun> runs_along(const Ground& ground, const Ring& line, double room_m) {
  CornerLine corners{ground, line, room_m};
  bool moved = true;
  for (int round = 0; moved && round < kMostRepairs; ++round) {
    if (!corners.make_room()) return runs_on_edges(ground, line, room_m);
    corners.make_gentle();
    moved = corners.repair();
  }
  if (!corners.make_room()) return runs_on_edges(ground, line, room_m);
  if (!moved && corners.fits()) return {{corners.path(), true}};
  return corners.fitting_runs();
}

}  // namespace

bool CornerLine::fits() const { return selion::fits(ground_.space, ground_.footprint, path()); }

std::vector<HeadlandRun> CornerLine::fitting_runs() const {
  std::vector<Path> steps;
  Index i = first_;
  for (std::size_t k = 0; k < count_; ++k, i = next(i)) {
    for (const Stretch& whole : edge_path(i))
      for (Path& step : steps_along(whole.curve.start, end_of(whole.curve).at))
        steps.push_back(std::move(step));
    steps.push_back(corner_at(next(i)));
  }
  const auto gap = std::find_if_not(steps.begin(), steps.end(), [this](const Path& step) {
    return selion::fits(ground_.space, ground_.footprint, step);
  });
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

/// Where the ring itself leads nowhere round, by lines that stray further, away from the border: its noise is
/// no way. A loop that leaves much of the ring out, as in a band in which it turns too early, has to work
/// more than runs along the sides would.
std::vector<HeadlandRun> drivable_along(const Ground& ground, const Ring& ring, double room_m) {
  constexpr double kAllRound = 0.8;
  Longest longest{ground};
  for (const double stray_m : {kFollow_m, 5 * kFollow_m, 20 * kFollow_m}) {
    const Ring line = stray_m > kFollow_m ? simplified_to_left(ring, stray_m) : simplified(ring, stray_m);
    std::vector<HeadlandRun> runs = runs_along(ground, line, room_m);
    const bool loop = runs.size() == 1 && runs.front().closed;
    if (loop && length_m(runs.front().path) >= kAllRound * perimeter_m(Polygon{ring, {}})) return runs;
    longest.offer(std::move(runs));
    if (loop) longest.offer(runs_on_edges(ground, line, room_m));
  }
  return std::move(longest).runs();
}

}  // namespace selion
