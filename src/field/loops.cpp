// SPDX-License-Identifier: GPL-3.0-or-later
#include "loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "tangle.hpp"

namespace selion {
namespace {

struct ByPlace {
  bool operator()(Point a, Point b) const { return a.x_m != b.x_m ? a.x_m < b.x_m : a.y_m < b.y_m; }
};

/// Finds an earlier point within kSnap_m by a grid of that size.
class Snapper {
 public:
  Point snapped(Point p) {
    const auto column = static_cast<std::int64_t>(std::floor(p.x_m / kSnap_m));
    const auto row = static_cast<std::int64_t>(std::floor(p.y_m / kSnap_m));
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        if (const auto found = cells_.find({column + dx, row + dy});
            found != cells_.end() && distance_m(found->second, p) < kSnap_m)
          return found->second;
    cells_.emplace(std::pair{column, row}, p);
    return p;
  }

 private:
  std::map<std::pair<std::int64_t, std::int64_t>, Point> cells_;
};

/// Places to be put into the edges of a ring: edge (from its corner of this index), share along it, point.
struct Insertion {
  std::size_t edge = 0;
  double along = 0;
  Point at;
};

Ring with(const Ring& ring, std::vector<Insertion> insertions) {
  std::stable_sort(insertions.begin(), insertions.end(), [](const Insertion& a, const Insertion& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.along < b.along;
  });
  Ring result;
  result.reserve(ring.size() + insertions.size());
  auto next = insertions.begin();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    result.push_back(ring[i]);
    for (; next != insertions.end() && next->edge == i; ++next)
      if (!(next->at == result.back())) result.push_back(next->at);
    if (i + 1 == ring.size())
      while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  }
  return result;
}

/// Share along a-b of the place nearest to p, where p is within kSnap_m of the edge but at neither end.
std::optional<double> touch(Point a, Point b, Point p) {
  if (p == a || p == b) return std::nullopt;
  const Point ab = b - a;
  const double along = dot(p - a, ab) / dot(ab, ab);
  if (along <= 0 || along >= 1 || distance_m(a + along * ab, p) >= kSnap_m) return std::nullopt;
  return along;
}

Ring with_touches(const Ring& ring, const std::vector<Point>& corners_by_x) {
  std::vector<Insertion> insertions;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    const auto [west, east] = std::minmax(a.x_m, b.x_m);
    const auto [south, north] = std::minmax(a.y_m, b.y_m);
    auto p = std::lower_bound(corners_by_x.begin(), corners_by_x.end(), west - kSnap_m,
                              [](Point q, double x) { return q.x_m < x; });
    for (; p != corners_by_x.end() && p->x_m <= east + kSnap_m; ++p) {
      if (p->y_m < south - kSnap_m || p->y_m > north + kSnap_m) continue;
      if (const auto along = touch(a, b, *p)) insertions.push_back({i, *along, *p});
    }
  }
  return insertions.empty() ? ring : with(ring, std::move(insertions));
}

Ring with_crossings(const Ring& ring) {
  const auto next = [&](std::size_t i) { return ring[(i + 1) % ring.size()]; };
  std::vector<Insertion> insertions;
  (void)NearEdges{ring}.each_pair([&](std::size_t i, std::size_t k) {
    const Point a = ring[i];
    const Point b = next(i);
    const Point c = ring[k];
    const Point d = next(k);
    if (a == c || a == d || b == c || b == d) return true;
    const auto shares = crossing(a, b, c, d);
    if (!shares) return true;
    const Point at = a + shares->first * (b - a);
    insertions.push_back({i, shares->first, at});
    insertions.push_back({k, shares->second, at});
    return true;
  });
  return insertions.empty() ? ring : with(ring, std::move(insertions));
}

/// Appends `p` to `kept`, unless the line comes back to where it was one corner ago: then the tip goes.
void add_corner(Point p, Ring& kept, std::vector<Spike>& spikes) {
  if (kept.size() >= 2 && kept[kept.size() - 2] == p) {
    // A spike of several corners is popped from its tip down: it stays one spike.
    if (!spikes.empty() && spikes.back().foot == kept.back())
      spikes.back().foot = p;
    else
      spikes.push_back({p, kept.back()});
    kept.pop_back();
  } else if (kept.empty() || !(kept.back() == p)) {
    kept.push_back(p);
  }
}

/// Drops the spikes that have their tip or their foot where the ring starts.
void drop_spikes_at_seam(Ring& kept, std::vector<Spike>& spikes) {
  while (kept.size() > 2) {
    if (kept.back() == kept.front()) {
      kept.pop_back();
    } else if (kept[kept.size() - 2] == kept.front()) {
      spikes.push_back({kept.front(), kept.back()});
      kept.resize(kept.size() - 2);
    } else if (kept.back() == kept[1]) {
      spikes.push_back({kept[1], kept.front()});
      kept.erase(kept.begin());
      kept.pop_back();
    } else {
      return;
    }
  }
}

}  // namespace

int snap(std::vector<Ring>& rings) {
  Snapper snapper;
  int dropped = 0;
  std::vector<Point> corners;
  for (Ring& ring : rings) {
    for (Point& p : ring) p = snapper.snapped(p);
    const std::size_t before = ring.size();
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    dropped += static_cast<int>(before - ring.size());
    corners.insert(corners.end(), ring.begin(), ring.end());
  }
  std::sort(corners.begin(), corners.end(), ByPlace{});
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (Ring& ring : rings) ring = with_touches(ring, corners);
  return dropped;
}

std::vector<Spike> drop_spikes(Ring& ring) {
  std::vector<Spike> spikes;
  if (ring.size() < 3) return spikes;
  Ring kept;
  for (const Point p : ring) add_corner(p, kept, spikes);
  drop_spikes_at_seam(kept, spikes);
  ring = std::move(kept);
  return spikes;
}

std::vector<Loop> loops_of(const Ring& ring) {
  std::vector<Loop> loops;
  Ring path;
  std::map<Point, std::size_t, ByPlace> seen;
  for (const Point p : with_crossings(ring)) {
    const auto [known, is_new] = seen.try_emplace(p, path.size());
    if (is_new) {
      path.push_back(p);
      continue;
    }
    const auto from = path.begin() + static_cast<std::ptrdiff_t>(known->second);
    loops.push_back({Ring(from, path.end()), p});
    for (auto corner = from + 1; corner != path.end(); ++corner) seen.erase(*corner);
    path.erase(from + 1, path.end());
  }
  if (path.empty()) return loops;
  Point pinch = path.front();
  for (const Loop& loop : loops)  // the rest closes where the others were cut off it
    if (seen.contains(loop.pinch)) pinch = loop.pinch;
  loops.push_back({std::move(path), pinch});
  return loops;
}

}  // namespace selion
