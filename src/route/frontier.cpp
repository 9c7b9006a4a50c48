// SPDX-License-Identifier: GPL-3.0-or-later
#include "frontier.hpp"

#include <algorithm>
#include <limits>

#include "selion/motion/dubins.hpp"

namespace selion {
namespace {

constexpr double kRounding_m = 1e-9;
constexpr double kLonger = 4;  // radii: a turn so much longer than its Dubins path leads round by elsewhere

double longest_m(const Terrain& terrain, const Link& link) {
  return link.turn_m + kLonger / terrain.limits.curvature_per_m;
}

}  // namespace

Link link_between(const Terrain& terrain, std::size_t to, const Pose& start, const Pose& end) {
  Link link;
  link.to = to;
  link.start = start;
  link.end = end;
  link.turn_m = dubins_length_m(start, end, 1 / terrain.limits.curvature_per_m);
  link.least_m = link.turn_m;
  return link;
}

void look_for_turn(const Terrain& terrain, const Link& link, KnownTurn& known) {
  const double most_m = longest_m(terrain, link);
  if (link.without_stops)
    known = {turn_with_stops(terrain, link.start, link.end, most_m), true};
  else
    known = turn_soon_found(terrain, link.start, link.end, most_m);
}

void work_out(const Terrain& terrain, Link& link, const KnownTurn& known) {
  link.worked_out = known.is_all;
  if (!known.is_all && !link.without_stops) {
    link.without_stops = true;
    const double rest_m = link.least_m - link.turn_m;
    link.least_m = rest_m + std::max(link.turn_m, least_with_stop_m(terrain, link.start, link.end));
  }
  if (!known.turn) return;
  link.is_first_found = true;
  link.path = *known.turn;
  if (link.after != nullptr) append(link.path, *link.after);
  link.cost_m = cost_m(terrain, link.path);
}

Path at_its_fastest(const Terrain& terrain, const Link& link) {
  if (!link.is_first_found) return link.path;
  auto turn = direct_turn(terrain, terrain.swings, link.start, link.end, longest_m(terrain, link));
  if (!turn) return link.path;
  if (link.after != nullptr) append(*turn, *link.after);
  if (cost_m(terrain, *turn) >= link.cost_m) return link.path;
  return std::move(*turn);
}

double Frontier::cost_m(std::size_t node) const {
  if (node == kStart) return 0;
  const auto known = reached_.find(node);
  return known == reached_.end() ? std::numeric_limits<double>::infinity() : known->second.cost_m;
}

void Frontier::propose(std::size_t from, Link& link, double rest_m) {
  const double least_m = cost_m(from) + (link.worked_out ? link.cost_m : link.least_m);
  if (least_m < cost_m(link.to)) open_.push({least_m + rest_m, serial_++, from, &link});
}

void Frontier::drive(std::size_t from, const Link& link, double rest_m) {
  const double cost = cost_m(from) + link.cost_m;
  if (cost >= cost_m(link.to)) return;
  reached_[link.to] = {cost, from, &link};
  open_.push({cost + rest_m, serial_++, link.to, nullptr});
}

Frontier::Entry Frontier::take() {
  const Entry lowest = open_.top();
  open_.pop();
  return lowest;
}

bool Frontier::promises(const Entry& entry) const {
  const Link& link = *entry.link;
  return cost_m(entry.node) + (link.worked_out ? link.cost_m : link.least_m) < cost_m(link.to);
}

bool Frontier::outdated(const Entry& entry, double rest_m) const {
  return cost_m(entry.node) + rest_m < entry.bound_m - kRounding_m;
}

std::vector<const Link*> Frontier::way_to(std::size_t node) const {
  std::vector<const Link*> links;
  for (std::size_t at = node; at != kStart; at = reached_.at(at).parent) links.push_back(reached_.at(at).by);
  std::reverse(links.begin(), links.end());
  return links;
}

std::optional<std::size_t> Frontier::cheapest_from(std::size_t first) const {
  std::optional<std::size_t> best;
  for (const std::size_t node : reached())
    if (node >= first && (!best || cost_m(node) < cost_m(*best))) best = node;
  return best;
}

std::vector<std::size_t> Frontier::reached() const {
  std::vector<std::size_t> nodes;
  for (const auto& [node, how] : reached_) nodes.push_back(node);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace selion
