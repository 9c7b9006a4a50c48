// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "route/guide.hpp"
#include "route/roads.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;

Machine robot() {
  for (const MachinePreset& known : machine_presets())
    if (known.name == "robot-3m") return known.machine;
  return {};
}

Machine only_ahead(Machine machine) {
  machine.may_reverse = false;
  machine.may_pivot = false;
  return machine;
}

/// All of `area` is headland.
struct Ground {
  explicit Ground(Polygon area, Machine driven = robot())
      : machine{std::move(driven)}, space{free_space(area, footprint_of(machine))} {}

  Machine machine;
  FreeSpace space;
  AreaIndex mainland{{}};
  CurveLimits limits = limits_at(machine, machine.turn_speed_mps);
  Terrain terrain{space,  footprint_of(machine), limits, Swings{limits}, machine.may_reverse, mainland,
                  machine};
};

/// Out of the one a gap leads round a corner into the other.
Polygon two_yards() {
  return {{{0, 0},
           {40, 0},
           {40, 14},
           {44, 14},
           {44, 0},
           {70, 0},
           {70, 30},
           {44, 30},
           {44, 18},
           {40, 18},
           {40, 30},
           {0, 30}},
          {}};
}

bool reverses(const Path& path) {
  return std::any_of(path.begin(), path.end(), [](const Stretch& s) { return s.gear == Gear::reverse; });
}

double backwards_m(const Path& path) {
  double sum = 0;
  for (const Stretch& s : path) sum += s.gear == Gear::reverse ? s.curve.length_m : 0;
  return sum;
}

}  // namespace

TEST_CASE("a goal that one part of the roads does not lead to is found from another", "[route]") {
  // two yards, joined by a gap too narrow for the machine; through the second one a wall
  const Ground ground{Polygon{{{0, 0},
                               {60, 0},
                               {60, 19},
                               {64, 19},
                               {64, 0},
                               {400, 0},
                               {400, 40},
                               {64, 40},
                               {64, 20},
                               {60, 20},
                               {60, 40},
                               {0, 40}},
                              {{{66, 18}, {66, 22}, {360, 22}, {360, 18}}}}};
  const auto road = [](Point from, Point to) {
    return track_of(Path{{line(from, to), Gear::forward}}, false);
  };
  KnownGround known;
  Roads roads{ground.terrain,
              {road({10, 8}, {50, 8}), road({74, 8}, {386, 8}), road({392, 12}, {392, 28}),
               road({386, 32}, {74, 32})},
              known};
  const std::vector<Pose> goal{{{90, 32}, kPi}};
  CHECK_FALSE(roads.way({{12, 8}, 0}, goal, {}));
  CHECK_FALSE(roads.way({{15, 8}, 0}, goal, {}));
  const auto way = roads.way({{76, 8}, 0}, goal, {});
  REQUIRE(way);
  CHECK(distance_m(end_pose(way->way).at, goal.front().at) < 1e-6);
  CHECK(length_m(way->way) > 500);  // round the wall: not found at once
  CHECK(stays_inside(ground.space, ground.terrain.footprint, way->way));
}

TEST_CASE("the turns of a way over the roads are the fastest, whichever was found first", "[route]") {
  int faster = 0;
  for (const double beyond_m : {20.0, 9.0, 7.5})
    for (const double aside_m : {1.0, 2.0, 3.0, 4.0, 5.0}) {
      CAPTURE(beyond_m, aside_m);
      const Ground ground{Polygon{{{-60, -60}, {beyond_m, -60}, {beyond_m, 60}, {-60, 60}}, {}}};
      const Pose to{{-6, aside_m}, 0};  // behind: by a loop, or backwards
      const auto fastest = direct_turn(ground.terrain, ground.terrain.swings, {}, to, 40);
      const KnownTurn ahead = turn_soon_found(ground.terrain, {}, to, 40);
      const auto soon = ahead.is_all ? ahead.turn : turn_with_stops(ground.terrain, {}, to, 40);
      REQUIRE(fastest);
      REQUIRE(soon);
      KnownGround known;
      const auto way = Roads{ground.terrain, {}, known}.way({}, {to}, {});
      REQUIRE(way);
      const double least_m = std::min(cost_m(ground.terrain, *fastest), cost_m(ground.terrain, *soon));
      CHECK(cost_m(ground.terrain, way->way) <= least_m + 1e-6);
      faster += reverses(*fastest) && !reverses(*soon) ? 1 : 0;
    }
  CHECK(faster > 0);
}

TEST_CASE("no turn leads far backwards over the mainland", "[route]") {
  int far = 0;
  for (const double behind_m : {1.0, 2.0, 3.0})  // between goal and border: it is hardly come to forwards
    for (const double aside_m : {1.0, 5.0, 20.0}) {
      CAPTURE(behind_m, aside_m);
      const double west_m = -60 - robot().rear_m - behind_m;
      const Polygon area{{{west_m, -60}, {60, -60}, {60, 60}, {west_m, 60}}, {}};
      Ground ground{area};
      const auto turn = [&] {
        return direct_turn(ground.terrain, ground.terrain.swings, {}, {{-60, aside_m}, 0}, 1000);
      };
      const auto beside = turn();
      far += beside && backwards_m(*beside) > 40 ? 1 : 0;
      ground.mainland = AreaIndex{{area}};
      const auto over = turn();
      CHECK((!over || backwards_m(*over) < 40));
    }
  CHECK(far > 0);
}

TEST_CASE("a far transfer goes round by the headland, not over rows just sown", "[route]") {
  const Polygon area{{{0, 0}, {200, 0}, {200, 100}, {0, 100}}, {}};
  const Ground bare{area};
  Ground ground{area};
  ground.mainland = AreaIndex{{Polygon{{{16, 16}, {184, 16}, {184, 84}, {16, 84}}, {}}}};
  const auto road = [](Point from, Point to) {
    return track_of(Path{{line(from, to), Gear::forward}}, false);
  };
  const std::vector<Track> round{road({16, 8}, {184, 8}), road({192, 16}, {192, 84}),
                                 road({184, 92}, {16, 92}), road({8, 84}, {8, 16})};
  for (const double heading : {0.0, kPi / 2, kPi}) {
    CAPTURE(heading);
    KnownGround known;
    const auto way =
        Roads{ground.terrain, round, known}.way({{20, 8}, heading}, {{{180, 92}, kPi - heading}}, {});
    REQUIRE(way);
    const double dearer_m = cost_m(ground.terrain, way->way) - cost_m(bare.terrain, way->way);
    CHECK(dearer_m < 40 * kOverMainland);  // straight across: 140
  }
}

TEST_CASE("what is left of a way over a large field is known to lead along its headland", "[route]") {
  const Polygon area{{{0, 0}, {1400, 0}, {1400, 1000}, {0, 1000}}, {}};
  Ground ground{area};
  ground.mainland = AreaIndex{{Polygon{{{4, 4}, {1396, 4}, {1396, 996}, {4, 996}}, {}}}};
  const Pose from{{2, 2}, 0};
  const std::vector<Pose> goal{{{1398, 998}, kPi / 2}};
  const Guide guide{ground.terrain, from, goal, std::numeric_limits<double>::infinity(), 150};
  CHECK(guide.to_goal_m(from.at) < 1400 + 1000);  // straight across costs 5100
  CHECK(guide.to_goal_m({700, 500}) > 0.9 * 3 * 490);
}

TEST_CASE("of one road the place where one stands comes first, however it is rounded, then one some way on",
          "[route]") {
  const Ground ground{Polygon{{{0, 0}, {100, 0}, {100, 20}, {0, 20}}, {}}};
  Path crooked;
  for (double x_m = 10; x_m < 90; x_m += 2)
    crooked.push_back({line({x_m, 10}, {x_m + 2, 10}), Gear::forward});
  KnownGround known;
  const Roads roads{ground.terrain, {track_of(crooked, false)}, known};
  const std::size_t here = roads.size() / 2;
  const double off_m = GENERATE(-1e-12, 0.0, 1e-12);
  CAPTURE(off_m);
  const Pose& station = roads.pose(here);
  const auto likely = roads.likely_after({station.at + Point{off_m, 0}, station.heading_rad});
  REQUIRE(likely.size() == 2);
  CHECK(likely.front() == here);
  const double apart_m = roads.pose(likely.back()).at.x_m - station.at.x_m;
  CHECK(apart_m >= 2 / ground.limits.curvature_per_m);
  CHECK(apart_m < 2 / ground.limits.curvature_per_m + 2.1);
}

TEST_CASE("where the roads lead to no goal, the way back out of the last work still may", "[route]") {
  // a yard, and a dead end into which the machine, which drives forwards only, gets in but not round
  const Ground ground{
      Polygon{{{-120, -2}, {0, -2}, {0, -20}, {60, -20}, {60, 20}, {0, 20}, {0, 2}, {-120, 2}}, {}},
      only_ahead(robot())};
  std::vector<Track> lines;
  for (const double y_m : {-15.0, -9.0, -3.0, 3.0, 9.0, 15.0}) {
    lines.push_back(track_of(Path{{line({12, y_m}, {50, y_m}), Gear::forward}}, false));
    lines.push_back(track_of(Path{{line({50, y_m}, {12, y_m}), Gear::forward}}, false));
  }
  KnownGround known;
  Roads roads{ground.terrain, lines, known};
  const std::vector<Pose> goal{{{-100, 0}, 0}};
  CHECK_FALSE(roads.way({{20, 0}, 0}, goal, {}));
  const Pose here{{4, 0}, 0};
  const auto way = roads.way(here, goal, {backed(Path{{line({-115, 0}, here.at), Gear::forward}})});
  REQUIRE(way);
  CHECK(distance_m(end_pose(way->way).at, goal.front().at) < 1e-6);
  CHECK(stays_inside(ground.space, ground.terrain.footprint, way->way));
}

TEST_CASE("what one search has learned of the ground leads the next one nowhere else", "[route]") {
  const Ground ground{two_yards()};
  const std::vector<Pose> from{{{10, 6}, kPi}};
  KnownGround known;
  for (const Pose& goal : {Pose{{60, 22}, kPi / 2}, Pose{{58, 6}, kPi}, Pose{{60, 22}, -kPi / 2}}) {
    KnownGround nothing;
    const auto fresh = searched(ground.terrain, from, {goal}, nothing);
    REQUIRE(fresh);
    CHECK(stays_inside(ground.space, ground.terrain.footprint, fresh->arrival.way));
    for (int again = 0; again < 2; ++again) {
      const auto found = searched(ground.terrain, from, {goal}, known);
      REQUIRE(found);
      CHECK(found->arrival.way == fresh->arrival.way);
    }
  }
  CHECK(!known.moves.empty());
}

TEST_CASE("goals near at hand that cannot be driven into keep no search from one far off", "[route]") {
  // their backs to the wall of the first yard, the way out of which leads round a corner
  const Ground ground{two_yards(), only_ahead(robot())};
  const double rear_m = ground.machine.rear_m + 0.1;
  std::vector<Pose> goals;
  for (int i = 0; i < 5; ++i) goals.push_back({{6.0 + 5 * i, rear_m}, kPi / 2});
  for (const Pose& goal : goals) REQUIRE(fits(ground.space, ground.terrain.footprint, goal));
  goals.push_back({{60, 22}, kPi / 2});
  KnownGround known;
  const auto found = searched(ground.terrain, {{{20, 15}, kPi}}, goals, known);
  REQUIRE(found);
  CHECK(found->arrival.goal + 1 == goals.size());
  CHECK(distance_m(end_pose(found->arrival.way).at, goals.back().at) < 1e-6);
  CHECK(stays_inside(ground.space, ground.terrain.footprint, found->arrival.way));
  goals.pop_back();
  CHECK_FALSE(searched(ground.terrain, {{{20, 15}, kPi}}, goals, known));
}
