// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace selion {
namespace {

constexpr double kApart = 4;     // widths between the places kept of a pass
constexpr double kBeside = 1.5;  // widths between passes side by side

std::vector<Point> places_along(const Path& path, double step_m) {
  std::vector<Point> places;
  for (const Pose& pose : poses(path, step_m)) places.push_back(pose.at);
  return places;
}

/// Points by squares of the side that is looked around for.
class Neighbourhood {
 public:
  explicit Neighbourhood(double near_m) : near_m_{near_m} {}

  void add(Point p, std::size_t owner) { squares_[square(p)].push_back({p, owner}); }
  void owners_near(Point p, std::set<std::size_t>& owners) const {
    const auto [x, y] = square(p);
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy)
        if (const auto found = squares_.find({x + dx, y + dy}); found != squares_.end())
          for (const auto& [at, owner] : found->second)
            if (distance_m(at, p) < near_m_) owners.insert(owner);
  }

 private:
  using Square = std::pair<long long, long long>;
  [[nodiscard]] Square square(Point p) const {
    return {std::llround(p.x_m / near_m_), std::llround(p.y_m / near_m_)};
  }
  double near_m_;
  std::map<Square, std::vector<std::pair<Point, std::size_t>>> squares_;
};

}  // namespace

RingOrder::RingOrder(const Layout& layout, double width_m, RingSense sense) {
  for (const HeadlandPass& pass : layout.headland_passes)
    entries_.push_back({&pass, places_along(pass.path, kApart * width_m), {}, false});
  find_neighbours(width_m, sense == RingSense::inwards ? -1 : 1);
}

/// Those `step` rings further in.
void RingOrder::find_neighbours(double width_m, int step) {
  std::map<int, Neighbourhood> rings;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Neighbourhood& ring = rings.try_emplace(entries_[i].pass->ring, kBeside * width_m).first->second;
    for (const Point p : places_along(entries_[i].pass->path, width_m)) ring.add(p, i);
  }
  for (Entry& entry : entries_) {
    const auto ring = rings.find(entry.pass->ring + step);
    if (ring == rings.end()) continue;
    std::set<std::size_t> owners;
    for (const Point p : entry.places) ring->second.owners_near(p, owners);
    entry.before.assign(owners.begin(), owners.end());
  }
}

bool RingOrder::ready(const Entry& entry) const {
  return !entry.is_done && std::all_of(entry.before.begin(), entry.before.end(),
                                       [this](std::size_t i) { return entries_[i].is_done; });
}

double RingOrder::far_m(const Entry& entry, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point place : entry.places) least = std::min(least, distance_m(place, p));
  return least;
}

bool RingOrder::empty() const {
  return std::all_of(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.is_done; });
}

std::size_t RingOrder::nearest(const std::optional<Point>& here,
                               const std::optional<Point>& last_near) const {
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (ready(entries_[i])) ranked.emplace_back(here ? far_m(entries_[i], *here) : 0, i);
  if (last_near && ranked.size() > 1) {
    const auto last = std::min_element(ranked.begin(), ranked.end(), [&](const auto& a, const auto& b) {
      return far_m(entries_[a.second], *last_near) < far_m(entries_[b.second], *last_near);
    });
    ranked.erase(last);
  }
  return std::min_element(ranked.begin(), ranked.end())->second;
}

void RingOrder::done(std::size_t i) { entries_[i].is_done = true; }

bool RingOrder::ends_group(std::size_t i) const {
  return std::none_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return ready(entry) && std::find(entry.before.begin(), entry.before.end(), i) != entry.before.end();
  });
}

bool RingOrder::is_last_group() const {
  return std::count_if(entries_.begin(), entries_.end(),
                       [this](const Entry& entry) { return ready(entry); }) == 1;
}

std::vector<Point> RingOrder::next_places() const {
  std::vector<Point> places;
  for (const Entry& entry : entries_)
    if (ready(entry)) places.insert(places.end(), entry.places.begin(), entry.places.end());
  return places;
}

}  // namespace selion
