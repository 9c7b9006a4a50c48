// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/geometry/free_space.hpp"

#include <algorithm>
#include <cmath>

namespace selion {
namespace {

Box box_of(Point a, Point b) {
  return {{std::min(a.x_m, b.x_m), std::min(a.y_m, b.y_m)}, {std::max(a.x_m, b.x_m), std::max(a.y_m, b.y_m)}};
}

Box box_of(std::span<const Point> shape) {
  Box box{shape.front(), shape.front()};
  for (const Point p : shape) {
    box.low = {std::min(box.low.x_m, p.x_m), std::min(box.low.y_m, p.y_m)};
    box.high = {std::max(box.high.x_m, p.x_m), std::max(box.high.y_m, p.y_m)};
  }
  return box;
}

Box grown(Box box, double by_m) { return {box.low - Point{by_m, by_m}, box.high + Point{by_m, by_m}}; }

/// Is all of segment a-b right of (outside) one edge of the shape, or the shape all on one side of the
/// segment?
bool apart(std::span<const Point> shape, Point a, Point b) {
  for (std::size_t i = 0, j = shape.size() - 1; i < shape.size(); j = i++) {
    const Point along = shape[i] - shape[j];
    if (cross(along, a - shape[j]) <= 0 && cross(along, b - shape[j]) <= 0) return true;
  }
  bool left = false;
  bool right = false;
  for (const Point p : shape) (cross(b - a, p - a) > 0 ? left : right) = true;
  return !(left && right);
}

}  // namespace

FreeSpace::FreeSpace(const Polygon& area, double reach_m) : area_{area}, index_{{area}} {
  const auto take = [this](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      edges_.push_back({ring[j], ring[i]});
  };
  take(area.shell);
  for (const Ring& hole : area.holes) take(hole);
  constexpr double kMostCells = 1000;  // a side
  const Box box = grown(bounds(area.shell), reach_m);
  const Point size = box.high - box.low;
  low_ = box.low;
  cell_m_ = std::max({reach_m / 3, std::max(size.x_m, size.y_m) / kMostCells, 0.5});
  cells_per_m_ = 1 / cell_m_;
  columns_ = static_cast<int>(size.x_m / cell_m_) + 1;
  rows_ = static_cast<int>(size.y_m / cell_m_) + 1;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  near_.resize(cells, 0);
  std::vector<Crossing> crossings;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) add(e, reach_m, crossings);
  pack(std::move(crossings));
}

/// Beyond the grid the nearest cell's.
int FreeSpace::column_of(double x_m) const {
  return static_cast<int>(std::clamp((x_m - low_.x_m) * cells_per_m_, 0.0, columns_ - 1.0));
}

int FreeSpace::row_of(double y_m) const {
  return static_cast<int>(std::clamp((y_m - low_.y_m) * cells_per_m_, 0.0, rows_ - 1.0));
}

FreeSpace::Cells FreeSpace::cells_of(const Box& box) const {
  return {column_of(box.low.x_m), column_of(box.high.x_m), row_of(box.low.y_m), row_of(box.high.y_m)};
}

std::size_t FreeSpace::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

void FreeSpace::mark_near(const Cells& cells) {
  for (int row = cells.bottom; row <= cells.top; ++row)
    for (int column = cells.left; column <= cells.right; ++column) near_[index(column, row)] = 1;
}

/// Walks along the edge in steps of a cell, so that a long slanted edge does not fill its whole box.
void FreeSpace::add(std::uint32_t edge, double reach_m, std::vector<Crossing>& crossings) {
  const auto [a, b] = edges_[edge];
  const int steps = std::max(1, static_cast<int>(std::ceil(distance_m(a, b) / cell_m_)));
  for (int i = 0; i < steps; ++i) {
    const Point from = a + (static_cast<double>(i) / steps) * (b - a);
    const Point to = a + (static_cast<double>(i + 1) / steps) * (b - a);
    const Box box = box_of(from, to);
    mark_near(cells_of(grown(box, reach_m)));
    const Cells cells = cells_of(box);
    for (int row = cells.bottom; row <= cells.top; ++row)
      for (int column = cells.left; column <= cells.right; ++column)
        crossings.emplace_back(index(column, row), edge);
  }
}

void FreeSpace::pack(std::vector<Crossing> crossings) {
  std::sort(crossings.begin(), crossings.end());
  crossings.erase(std::unique(crossings.begin(), crossings.end()), crossings.end());
  first_.reserve(near_.size() + 1);
  for (const auto& [cell, edge] : crossings) {
    first_.resize(cell + 1, static_cast<std::uint32_t>(crossing_.size()));
    crossing_.push_back(edge);
  }
  first_.resize(near_.size() + 1, static_cast<std::uint32_t>(crossing_.size()));
}

bool FreeSpace::empty(const Box& box) const {
  const Cells cells = cells_of(box);
  for (int row = cells.bottom; row <= cells.top; ++row)
    if (first_[index(cells.left, row)] != first_[index(cells.right, row) + 1]) return false;
  return true;
}

bool FreeSpace::clear(std::span<const Point> shape) const {
  const Cells cells = cells_of(box_of(shape));
  for (int row = cells.bottom; row <= cells.top; ++row) {
    const std::uint32_t end = first_[index(cells.right, row) + 1];
    for (std::uint32_t k = first_[index(cells.left, row)]; k < end; ++k) {
      const Edge& edge = edges_[crossing_[k]];
      if (!apart(shape, edge.a, edge.b)) return false;
    }
  }
  return true;
}

}  // namespace selion
