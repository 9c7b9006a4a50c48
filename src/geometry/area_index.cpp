// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/geometry/area_index.hpp"

#include <algorithm>

#include "crossing.hpp"

namespace selion {
namespace {

constexpr std::size_t kMostBands = 2000;

}  // namespace

AreaIndex::AreaIndex(const std::vector<Polygon>& areas) {
  for (const Polygon& area : areas) {
    take(area.shell);
    for (const Ring& hole : area.holes) take(hole);
  }
  if (edges_.empty()) return;
  south_m_ = north_m_ = edges_.front().a.y_m;
  for (const Edge& edge : edges_) {
    south_m_ = std::min(south_m_, edge.a.y_m);
    north_m_ = std::max(north_m_, edge.a.y_m);
  }
  bands_.resize(std::min(edges_.size(), kMostBands));
  for (const Edge& edge : edges_) {
    const auto [low, high] = std::minmax(edge.a.y_m, edge.b.y_m);
    for (std::size_t band = band_of(low); band <= band_of(high); ++band) bands_[band].push_back(edge);
  }
}

void AreaIndex::take(const Ring& ring) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) edges_.push_back({ring[j], ring[i]});
}

std::size_t AreaIndex::band_of(double y_m) const {
  if (!(north_m_ > south_m_)) return 0;
  const double share = (y_m - south_m_) / (north_m_ - south_m_);
  return std::min(static_cast<std::size_t>(share * static_cast<double>(bands_.size())), bands_.size() - 1);
}

bool AreaIndex::holds(Point p) const {
  if (edges_.empty() || !(p.y_m >= south_m_ && p.y_m <= north_m_)) return false;
  bool inside = false;
  for (const Edge& edge : bands_[band_of(p.y_m)]) {
    const RayMeets meets = ray_meets(edge.a, edge.b, p);
    if (meets == RayMeets::the_edge_at_p) return true;
    if (meets == RayMeets::crossing) inside = !inside;
  }
  return inside;
}

}  // namespace selion
