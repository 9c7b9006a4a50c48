// SPDX-License-Identifier: GPL-3.0-or-later
#include "tangle.hpp"

#include <algorithm>

#include "selion/core/error.hpp"
#include "text.hpp"

namespace selion {
namespace {

constexpr std::size_t kTogether = 8;          // boxes in one
constexpr int kMostCrossings = 10'000;        // a track of a day's drive has fewer
constexpr std::size_t kMostBeside = 200'000;  // pairs of sides: 600 slanted ones across the field have them
constexpr std::size_t kBesideEach = 20;       // and of each side, where many corners were walked unsteadily

}  // namespace

NearEdges::NearEdges(const Ring& ring) {
  std::vector<Box> boxes;
  boxes.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    boxes.push_back(
        {{std::min(a.x_m, b.x_m), std::min(a.y_m, b.y_m)}, {std::max(a.x_m, b.x_m), std::max(a.y_m, b.y_m)}});
  }
  levels_.push_back(std::move(boxes));
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> above;
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (i % kTogether == 0) above.push_back(below[i]);
      Box& box = above.back();
      box.low = {std::min(box.low.x_m, below[i].low.x_m), std::min(box.low.y_m, below[i].low.y_m)};
      box.high = {std::max(box.high.x_m, below[i].high.x_m), std::max(box.high.y_m, below[i].high.y_m)};
    }
    levels_.push_back(std::move(above));
  }
}

std::size_t NearEdges::end_of(std::size_t level, std::size_t i) const {
  return std::min((i + 1) * kTogether, levels_[level - 1].size());
}

bool NearEdges::each_pair(const Visit& visit) const {
  return levels_.front().empty() || within(levels_.size() - 1, 0, visit);
}

bool NearEdges::within(std::size_t level, std::size_t i, const Visit& visit) const {
  if (level == 0) return true;
  for (std::size_t a = i * kTogether; a < end_of(level, i); ++a) {
    if (!within(level - 1, a, visit)) return false;
    for (std::size_t b = a + 1; b < end_of(level, i); ++b)
      if (!between(level - 1, a, b, visit)) return false;
  }
  return true;
}

bool NearEdges::between(std::size_t level, std::size_t i, std::size_t k, const Visit& visit) const {
  if (!meet(levels_[level][i], levels_[level][k])) return true;
  if (level == 0) return visit(i, k);
  for (std::size_t a = i * kTogether; a < end_of(level, i); ++a)
    for (std::size_t b = k * kTogether; b < end_of(level, k); ++b)
      if (!between(level - 1, a, b, visit)) return false;
  return true;
}

std::optional<std::pair<double, double>> crossing(Point a, Point b, Point c, Point d) {
  const double c_side = cross(b - a, c - a);
  const double d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c);
  const double b_side = cross(d - c, b - c);
  if (c_side * d_side >= 0 || a_side * b_side >= 0) return std::nullopt;
  return std::pair{a_side / (a_side - b_side), c_side / (c_side - d_side)};
}

void refuse_tangle(const Ring& ring, const LocalFrame& frame, const std::string& where) {
  int crossings = 0;
  std::size_t beside = 0;
  const std::size_t most_beside = kMostBeside + kBesideEach * ring.size();
  std::size_t last = 0;
  const auto next = [&](std::size_t i) { return ring[(i + 1) % ring.size()]; };
  const bool sound = NearEdges{ring}.each_pair([&](std::size_t i, std::size_t k) {
    last = i;
    if (crossing(ring[i], next(i), ring[k], next(k))) ++crossings;
    return crossings <= kMostCrossings && ++beside <= most_beside;
  });
  if (sound) return;
  const std::string what = crossings > kMostCrossings
                               ? " crosses itself more than " + std::to_string(kMostCrossings) + " times"
                               : " runs to and fro so often that " + std::to_string(most_beside) +
                                     " pairs of its sides lie abreast";
  throw InputError{where + what + " near " + place(frame.to_lonlat(ring[last])) +
                   "; this is no border: draw it anew"};
}

}  // namespace selion
