// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <string>

#include "route/ring_order.hpp"

using namespace selion;

namespace {

/// All round a square of half a side `half_m`.
HeadlandPass square(std::string id, int ring, Point middle, double half_m) {
  const Ring corners{{-half_m, -half_m}, {half_m, -half_m}, {half_m, half_m}, {-half_m, half_m}};
  HeadlandPass pass{std::move(id), ring, {}, true, {}};
  for (std::size_t i = 0; i < 4; ++i)
    pass.path.push_back({line(middle + corners[i], middle + corners[(i + 1) % 4]), Gear::forward});
  return pass;
}

/// A border with two rings and two obstacles, west and east, with three rings each, 4 m apart.
Layout two_obstacles() {
  Layout layout;
  for (const int ring : {1, 2}) layout.headland_passes.push_back(square("b", ring, {0, 0}, 102 - 4 * ring));
  for (const int ring : {1, 2, 3}) {
    layout.headland_passes.push_back(square("w", ring, {-50, 0}, 4 + 4 * ring));
    layout.headland_passes.push_back(square("e", ring, {50, 0}, 4 + 4 * ring));
  }
  return layout;
}

std::string worked(RingOrder order, std::optional<Point> here, std::optional<Point> last_near) {
  std::string all;
  while (!order.empty()) {
    const std::size_t next = order.nearest(here, last_near);
    order.done(next);
    here = start_pose(order.pass(next).path).at;
    all +=
        order.pass(next).id + std::to_string(order.pass(next).ring) + (order.ends_group(next) ? ". " : " ");
  }
  return all;
}

}  // namespace

TEST_CASE("all rings around one obstacle are worked before those around the next", "[route]") {
  const Layout layout = two_obstacles();
  CHECK(worked({layout, 4, RingSense::outwards}, Point{-60, 0}, std::nullopt) ==
        "w3 w2 w1. b2 b1. e3 e2 e1. ");
  CHECK(worked({layout, 4, RingSense::outwards}, Point{60, 0}, std::nullopt) ==
        "e3 e2 e1. b2 b1. w3 w2 w1. ");
}

TEST_CASE("inwards, rings are worked from border and obstacle on", "[route]") {
  const Layout layout = two_obstacles();
  CHECK(worked({layout, 4, RingSense::inwards}, Point{-95, 0}, std::nullopt) ==
        "b1 b2. w1 w2 w3. e1 e2 e3. ");
}

TEST_CASE("the rings beside the gate come last", "[route]") {
  const Layout layout = two_obstacles();
  CHECK(worked({layout, 4, RingSense::outwards}, Point{-60, 0}, Point{-100, 0}) ==
        "w3 w2 w1. e3 e2 e1. b2 b1. ");
}
