// SPDX-License-Identifier: GPL-3.0-or-later
#include "segments.hpp"

#include <algorithm>
#include <cmath>

namespace selion::verifying {
namespace {

constexpr std::size_t kTogether = 4;  // boxes, or segments, in one

bool finite(Point p) { return std::isfinite(p.x_m) && std::isfinite(p.y_m); }

/// Does a line across `axis` part the corners from the segment?
bool parted(const Corners& corners, const Segment& segment, Point axis) {
  const auto [low, high] = std::minmax(
      {dot(axis, corners[0]), dot(axis, corners[1]), dot(axis, corners[2]), dot(axis, corners[3])});
  const auto [first, last] = std::minmax({dot(axis, segment.from), dot(axis, segment.to)});
  const double off = kOff_m * (std::abs(axis.x_m) + std::abs(axis.y_m));
  return first - high > off || low - last > off;
}

bool cross_each_other(const Segment& e, const Segment& f) {
  const auto parts = [](const Segment& line, const Segment& other) {
    const double a = cross(line.to - line.from, other.from - line.from);
    const double b = cross(line.to - line.from, other.to - line.from);
    return (a < 0 && b > 0) || (a > 0 && b < 0);
  };
  return parts(e, f) && parts(f, e);
}

bool parted(const Corners& corners, const Segment& segment) {
  return parted(corners, segment, left_of(segment.to - segment.from)) ||
         parted(corners, segment, corners[1] - corners[0]) ||
         parted(corners, segment, corners[2] - corners[1]);
}

double distance_m(const Segment& segment, Point p) {
  const Point along = segment.to - segment.from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - segment.from, along) / square, 0.0, 1.0) : 0;
  const Point off = segment.from + share * along - p;
  return std::sqrt(dot(off, off));
}

double distance_m(const Box& box, Point p) {
  const double x = std::max({0.0, box.low.x_m - p.x_m, p.x_m - box.high.x_m});
  const double y = std::max({0.0, box.low.y_m - p.y_m, p.y_m - box.high.y_m});
  return std::sqrt(x * x + y * y);
}

/// No side of either, and no line across one, parts them.
bool meet(const Corners& a, const Corners& b) {
  const auto parted = [&](Point axis) {
    const auto [a_low, a_high] =
        std::minmax({dot(axis, a[0]), dot(axis, a[1]), dot(axis, a[2]), dot(axis, a[3])});
    const auto [b_low, b_high] =
        std::minmax({dot(axis, b[0]), dot(axis, b[1]), dot(axis, b[2]), dot(axis, b[3])});
    return a_low > b_high || b_low > a_high;
  };
  for (const Corners& corners : {a, b})
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point side = corners[(i + 1) % corners.size()] - corners[i];
      if (parted(side) || parted(left_of(side))) return false;
    }
  return true;
}

}  // namespace

double distance_m(const Corners& a, const Corners& b) {
  if (meet(a, b)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k)
      least = std::min({least, distance_m(Segment{a[i], a[(i + 1) % a.size()]}, b[k]),
                        distance_m(Segment{b[k], b[(k + 1) % b.size()]}, a[i])});
  return least;
}

Segments::Segments(const std::vector<std::vector<Point>>& lines) {
  for (const auto& line : lines) {
    if (!std::ranges::all_of(line, finite)) {
      segments_.clear();
      return;
    }
    for (std::size_t i = line.size() > 1 ? 1 : 0; i < line.size(); ++i)
      segments_.push_back({line[i == 0 ? 0 : i - 1], line[i]});
  }
  std::vector<Box> boxes((segments_.size() + kTogether - 1) / kTogether);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    boxes[i / kTogether].take_in(segments_[i].from);
    boxes[i / kTogether].take_in(segments_[i].to);
  }
  levels_.push_back(std::move(boxes));
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> above((below.size() + kTogether - 1) / kTogether);
    for (std::size_t i = 0; i < below.size(); ++i) {
      above[i / kTogether].take_in(below[i].low);
      above[i / kTogether].take_in(below[i].high);
    }
    levels_.push_back(std::move(above));
  }
}

std::size_t Segments::end_of(std::size_t level, std::size_t i) const {
  return std::min((i + 1) * kTogether, level == 0 ? segments_.size() : levels_[level - 1].size());
}

bool Segments::clear_of(const Corners& corners) const {
  if (segments_.empty() || !std::ranges::all_of(corners, finite)) return false;
  Box around;
  for (const Point p : corners) around.take_in(p);
  return clear_of(corners, around, levels_.size() - 1, 0);
}

bool Segments::clear_of(const Corners& corners, const Box& around, std::size_t level, std::size_t i) const {
  if (apart(levels_[level][i], around)) return true;
  for (std::size_t k = i * kTogether; k < end_of(level, i); ++k)
    if (level == 0 ? !parted(corners, segments_[k]) : !clear_of(corners, around, level - 1, k)) return false;
  return true;
}

bool Segments::tangled(int crossings, int beside) const {
  Pairs left{crossings, beside};
  return !segments_.empty() && !take_pairs(levels_.size() - 1, 0, 0, left);
}

bool Segments::take_pairs(std::size_t level, std::size_t i, std::size_t k, Pairs& left) const {
  if (i != k && apart(levels_[level][i], levels_[level][k])) return true;
  for (std::size_t a = i * kTogether; a < end_of(level, i); ++a)
    for (std::size_t b = i == k ? a : k * kTogether; b < end_of(level, k); ++b)
      if (level > 0 ? !take_pairs(level - 1, a, b, left)
                    : a != b && !take_pair(segments_[a], segments_[b], left))
        return false;
  return true;
}

bool Segments::take_pair(const Segment& e, const Segment& f, Pairs& left) {
  Box one;
  one.take_in(e.from), one.take_in(e.to);
  Box other;
  other.take_in(f.from), other.take_in(f.to);
  if (apart(one, other)) return true;
  if (cross_each_other(e, f)) --left.crossings;
  return --left.beside >= 0 && left.crossings >= 0;
}

double Segments::farthest_m(std::span<const Point> places) const {
  constexpr double kNever_m = std::numeric_limits<double>::infinity();
  if (segments_.empty() || !std::ranges::all_of(places, finite)) return kNever_m;
  double most = 0;
  std::size_t last = 0;
  for (const Point p : places) {
    Nearest nearest = followed(p, last);
    last = nearest.segment;
    if (nearest.distance_m <= most) continue;  // the nearest is no farther
    look_for(p, levels_.size() - 1, 0, nearest);
    last = nearest.segment;
    most = std::max(most, nearest.distance_m);
  }
  return most;
}

Segments::Nearest Segments::followed(Point p, std::size_t from) const {
  Nearest nearest{from, distance_m(segments_[from], p)};
  for (std::size_t i = from + 1; i < segments_.size(); ++i) {
    const double off = distance_m(segments_[i], p);
    if (off > nearest.distance_m) break;
    nearest = {i, off};
  }
  return nearest;
}

void Segments::look_for(Point p, std::size_t level, std::size_t i, Nearest& nearest) const {
  if (distance_m(levels_[level][i], p) >= nearest.distance_m) return;
  for (std::size_t k = i * kTogether; k < end_of(level, i); ++k) {
    if (level > 0) {
      look_for(p, level - 1, k, nearest);
    } else if (const double off = distance_m(segments_[k], p); off < nearest.distance_m) {
      nearest = {k, off};
    }
  }
}

}  // namespace selion::verifying
