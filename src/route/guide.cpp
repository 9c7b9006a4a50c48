// SPDX-License-Identifier: GPL-3.0-or-later
#include "guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace selion {
namespace {

constexpr double kLeastCell_m = 0.75;
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

Guide::Guide(const Terrain& terrain, const Pose& from, const std::vector<Pose>& goals, double margin_m,
             double cells) {
  Ring places{from.at};
  for (const Pose& goal : goals) places.push_back(goal.at);
  const Box field = bounds(terrain.space.area().shell);
  const Box all = bounds(places);
  low_ = {std::max(field.low.x_m, all.low.x_m - margin_m), std::max(field.low.y_m, all.low.y_m - margin_m)};
  const Point high{std::min(field.high.x_m, all.high.x_m + margin_m),
                   std::min(field.high.y_m, all.high.y_m + margin_m)};
  const Point size = high - low_;
  const double side_m = std::max(size.x_m, size.y_m);
  cell_m_ = std::max(
      {kLeastCell_m, std::min(side_m / cells, terrain.machine.working_width_m), side_m / kMostCells});
  columns_ = static_cast<std::size_t>(std::max(0.0, size.x_m) / cell_m_) + 3;
  rows_ = static_cast<std::size_t>(std::max(0.0, size.y_m) / cell_m_) + 3;
  distance_.assign(columns_ * rows_, kFar);
  spread(terrain, goals);
}

std::optional<std::size_t> Guide::cell_of(Point p) const {
  const double x = std::floor((p.x_m - low_.x_m) / cell_m_);
  const double y = std::floor((p.y_m - low_.y_m) / cell_m_);
  if (x < 0 || y < 0 || x >= static_cast<double>(columns_ - 2) || y >= static_cast<double>(rows_ - 2))
    return std::nullopt;
  return (static_cast<std::size_t>(y) + 1) * columns_ + static_cast<std::size_t>(x) + 1;
}

Point Guide::centre_of(std::size_t cell) const {
  const std::size_t column = cell % columns_;
  const std::size_t row = cell / columns_;
  return low_ +
         Point{(static_cast<double>(column) - 0.5) * cell_m_, (static_cast<double>(row) - 0.5) * cell_m_};
}

/// To the cells around one.
std::array<Guide::Step, 8> Guide::steps() const {
  const double across_m = std::numbers::sqrt2 * cell_m_;
  const std::size_t left = 0 - std::size_t{1};
  const std::size_t down = 0 - columns_;
  return {{{down + left, across_m},
           {down, cell_m_},
           {down + 1, across_m},
           {left, cell_m_},
           {1, cell_m_},
           {columns_ + left, across_m},
           {columns_, cell_m_},
           {columns_ + 1, across_m}}};
}

/// Half the body has room there; touching squares keep the walk inside without asking again.
bool Guide::open(const Terrain& terrain, Point p) const {
  if (terrain.space.far_from_border(p)) return true;
  const double half = std::max(cell_m_ / 2, 0.8 * terrain.footprint.half_body_m);
  return terrain.space.clear(std::array{p + Point{-half, -half}, p + Point{half, -half},
                                        p + Point{half, half}, p + Point{-half, half}});
}

Guide::Ground Guide::ground_at(const Terrain& terrain, Point p) const {
  if (!open(terrain, p)) return Ground::closed;
  return terrain.mainland.holds(p) ? Ground::mainland : Ground::open;
}

double Guide::dearness(Ground ground) {
  if (ground == Ground::closed) return kFar;
  return ground == Ground::mainland ? 1 + kOverMainland : 1;
}

/// Dijkstra from the goals.
void Guide::spread(const Terrain& terrain, const std::vector<Pose>& goals) {
  Wave wave{terrain, steps(), unknown_within_rim(), Buckets(1)};
  for (const Pose& goal : goals)
    if (const auto start = cell_of(goal.at)) reach(wave.buckets, *start, 0);
  for (std::size_t b = 0; b < wave.buckets.size(); ++b) {
    for (std::size_t i = 0; i < wave.buckets[b].size(); ++i)  // more may come in by rounding
      go_on_from(wave.buckets[b][i], wave);
    wave.buckets[b] = {};
  }
}

void Guide::go_on_from(Reached done, Wave& wave) {
  if (done.distance_m > distance_[done.cell]) return;
  for (const Step step : wave.around) {
    const std::size_t other = done.cell + step.offset;
    if (done.distance_m + step.length_m >= distance_[other]) continue;  // on any ground
    Ground& there = wave.ground[other];
    if (there == Ground::unknown) there = ground_at(wave.terrain, centre_of(other));
    reach(wave.buckets, other, done.distance_m + step.length_m * dearness(there));
  }
}

std::vector<Guide::Ground> Guide::unknown_within_rim() const {
  std::vector<Ground> ground(distance_.size(), Ground::closed);
  for (std::size_t row = 1; row + 1 < rows_; ++row)
    std::fill_n(ground.begin() + static_cast<std::ptrdiff_t>(row * columns_ + 1), columns_ - 2,
                Ground::unknown);
  return ground;
}

void Guide::reach(Buckets& buckets, std::size_t cell, double distance_m) {
  if (distance_m >= distance_[cell]) return;
  distance_[cell] = distance_m;
  const auto bucket = static_cast<std::size_t>(distance_m / cell_m_);
  if (bucket >= buckets.size()) buckets.resize(bucket + 1);
  buckets[bucket].push_back({distance_m, cell});
}

double Guide::to_goal_m(Point p) const {
  const auto cell = cell_of(p);
  if (!cell) return kFar;
  double best = distance_[*cell];
  if (best < kFar) return best;
  // a pose may stand in a cell that is closed by the half body's square: look around it
  for (const Point step : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}})
    if (const auto other = cell_of(p + cell_m_ * step)) best = std::min(best, distance_[*other] + cell_m_);
  return best;
}

}  // namespace selion
