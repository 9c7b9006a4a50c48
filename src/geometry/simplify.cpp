// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/geometry/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace selion {
namespace {

double distance_to_segment_m(Point p, Point a, Point b) {
  const Point along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return distance_m(p, a + t * along);
}

/// Marks the corners to keep between `first` and `last`, ends kept already.
void keep_between(const Ring& ring, std::size_t first, std::size_t last, double tolerance_m,
                  std::vector<bool>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest_m = tolerance_m;
    std::size_t farthest = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double d = distance_to_segment_m(ring[i], ring[from], ring[to % ring.size()]);
      if (d > farthest_m) farthest_m = d, farthest = i;
    }
    if (farthest == from) continue;
    keep[farthest] = true;
    open.emplace_back(from, farthest);
    open.emplace_back(farthest, to);
  }
}

std::size_t corner_count(const Polygon& area) {
  std::size_t sum = area.shell.size();
  for (const Ring& hole : area.holes) sum += hole.size();
  return sum;
}

using Indices = std::vector<std::size_t>;

/// Of the corners that are kept; all of them where fewer than three would be.
Indices kept(const Ring& ring, double tolerance_m) {
  Indices all(ring.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (ring.size() < 4) return all;
  const auto farther = [&ring](const Point& a, const Point& b) {
    return distance_m(ring[0], a) < distance_m(ring[0], b);
  };
  const auto opposite =
      static_cast<std::size_t>(std::max_element(ring.begin(), ring.end(), farther) - ring.begin());
  std::vector<bool> keep(ring.size(), false);
  keep[0] = keep[opposite] = true;
  keep_between(ring, 0, opposite, tolerance_m, keep);
  keep_between(ring, opposite, ring.size(), tolerance_m, keep);
  Indices out;
  std::ranges::copy_if(all, std::back_inserter(out), [&keep](std::size_t i) { return keep[i]; });
  return out.size() < 3 ? all : out;
}

/// How far the ring lies left of the line from one of its corners to another.
double farthest_left_m(const Ring& ring, std::size_t from, std::size_t to) {
  const Point way = ring[to] - ring[from];
  const double length = length_m(way);
  double left_m = 0;
  for (std::size_t i = from; length > 0 && i != to; i = (i + 1) % ring.size())
    left_m = std::max(left_m, cross(way, ring[i] - ring[from]) / length);
  return left_m;
}

/// A corner moved so that both of its edges get `by_m` to the left, unless it is so sharp that it would move
/// far.
Point moved_left(Point before, Point at, Point after, double by_m) {
  constexpr double kMost = 3;
  const Point in = at - before;
  const Point out = after - at;
  if (by_m == 0 || !(length_m(in) > 0 && length_m(out) > 0)) return at;
  const Point normal = (1 / length_m(in)) * left_of(in);
  const Point middle = normal + (1 / length_m(out)) * left_of(out);
  const double square = dot(middle, middle);
  if (!(square > 1e-12)) return at;
  return at + by_m * std::min(2 / square, kMost / std::sqrt(square)) * middle;
}

}  // namespace

Ring simplified(const Ring& ring, double tolerance_m) {
  Ring out;
  for (const std::size_t i : kept(ring, tolerance_m)) out.push_back(ring[i]);
  return out;
}

Ring simplified_to_left(const Ring& ring, double tolerance_m) {
  const Indices corners = kept(ring, tolerance_m);
  const std::size_t count = corners.size();
  std::vector<double> left_m(count);  // of the edge from each
  for (std::size_t i = 0; i < count; ++i)
    left_m[i] = farthest_left_m(ring, corners[i], corners[(i + 1) % count]);
  Ring out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    out.push_back(moved_left(ring[corners[before]], ring[corners[i]], ring[corners[(i + 1) % count]],
                             std::max(left_m[before], left_m[i])));
  }
  return out;
}

Polygon simplified(const Polygon& area, double tolerance_m) {
  Polygon out{simplified(area.shell, tolerance_m), {}};
  out.holes.reserve(area.holes.size());
  for (const Ring& hole : area.holes) out.holes.push_back(simplified(hole, tolerance_m));
  return out;
}

Evened evened(const Polygon& area) {
  constexpr std::size_t kMany = 1000;  // corners: so many take long
  constexpr double kApart_m = 1;
  constexpr double kApartOfMany_m = 3;
  constexpr auto kStrays_m = std::to_array({0.005, 0.01, 0.02, 0.05, 0.1});
  const double most = perimeter_m(area) / (corner_count(area) > kMany ? kApartOfMany_m : kApart_m);
  Evened out{area, 0};
  for (const double stray_m : kStrays_m) {
    if (static_cast<double>(corner_count(out.area)) <= most) break;
    out = {simplified(area, stray_m), stray_m};
  }
  return out;
}

}  // namespace selion
