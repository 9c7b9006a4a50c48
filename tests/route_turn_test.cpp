// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "route/connect.hpp"
#include "selion/motion/timed_turn.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;

Machine preset(std::string_view name) {
  for (const MachinePreset& known : machine_presets())
    if (known.name == name) return known.machine;
  return {};
}

/// The ground beyond the ends of two swaths at x = 0: as deep as given, and wide.
class Ground {
 public:
  Ground(const Machine& machine, double depth_m)
      : machine_{machine},
        space_{
            free_space({{{-60, -60}, {depth_m, -60}, {depth_m, 60}, {-60, 60}}, {}}, footprint_of(machine))},
        mainland_{std::vector<Polygon>{Polygon{{{-60, -60}, {-20, -60}, {-20, 60}, {-60, 60}}, {}}}} {}

  [[nodiscard]] std::optional<Path> turn(double aside_m, double ahead_m) const {
    return turn({{ahead_m, aside_m}, kPi});
  }
  [[nodiscard]] std::optional<Path> turn(const Pose& to) const {
    const Terrain ground = terrain();
    return direct_turn(ground, ground.swings, {}, to, 1e9);
  }
  [[nodiscard]] std::optional<Path> turn_soon(const Pose& to, double most_m = 1e9) const {
    KnownTurn found = turn_soon_found(terrain(), {}, to, most_m);
    return found.is_all ? std::move(found.turn) : turn_with_stops(terrain(), {}, to, most_m);
  }
  [[nodiscard]] double costs_m(const Path& path) const { return cost_m(terrain(), path); }
  [[nodiscard]] double least_with_stop_m(const Pose& to) const {
    return selion::least_with_stop_m(terrain(), {}, to);
  }

  /// Of all families that the machine may drive, those that stay inside.
  [[nodiscard]] std::vector<Path> all(double aside_m, double ahead_m, bool forwards) const {
    const Swings swings{limits_at(machine_, machine_.turn_speed_mps)};
    std::vector<Path> inside;
    for (const TurnKind& kind : turns()) {
      if (!allows(manoeuvres_of(machine_), kind.needs) || forwards != (kind.needs == Needs::nothing))
        continue;
      for (Path& path : kind.candidates({}, {{ahead_m, aside_m}, kPi}, swings))
        if (stays_inside(space_, footprint_of(machine_), path)) inside.push_back(std::move(path));
    }
    return inside;
  }

 private:
  [[nodiscard]] Terrain terrain() const {
    const CurveLimits limits = limits_at(machine_, machine_.turn_speed_mps);
    return {space_,  footprint_of(machine_), limits, Swings{limits}, machine_.may_reverse, mainland_,
            machine_};
  }

  Machine machine_;
  FreeSpace space_;
  AreaIndex mainland_;
};

bool pivots(const Path& path) { return std::any_of(path.begin(), path.end(), is_pivot); }
bool reverses(const Path& path) {
  return std::any_of(path.begin(), path.end(), [](const Stretch& s) { return s.gear == Gear::reverse; });
}

}  // namespace

TEST_CASE("a place straight behind is reached straight back, though rounding puts it a hair aside",
          "[route][turn]") {
  const Ground ground{preset("tractor-6m"), 30};
  const double far_m = GENERATE(0.5, 21.3, 55.98);
  const double aside_m = GENERATE(0.0, 5e-8, -5e-8);
  const double heading_rad = GENERATE(0.0, 8e-8);
  CAPTURE(far_m, aside_m, heading_rad);
  const Pose to{{-far_m, aside_m}, heading_rad};
  const auto back = ground.turn(to);
  REQUIRE(back.has_value());
  REQUIRE(back->size() == 1);
  CHECK(back->front().gear == Gear::reverse);
  CHECK(distance_m(start_pose(*back).at, {}) < 1e-12);
  CHECK(distance_m(end_pose(*back).at, to.at) < 1e-7);
  CHECK(std::abs(end_pose(*back).heading_rad - heading_rad) < 3e-7);
}

TEST_CASE("of the turns that stay inside a machine drives none that takes longer than another",
          "[route][turn]") {
  const Machine machine = preset(GENERATE("robot-3m", "husky", "amiga", "tractor-6m", "tractor-12m"));
  const double beyond_m = GENERATE(30.0, 9.0, 5.0, 1.5);
  const double ahead_m = GENERATE(0.0, 1.5, -2.0);
  const Ground ground{machine, beyond_m};
  for (const double widths : {1.0, -1.0, 2.0}) {
    const double aside_m = widths * machine.working_width_m;
    CAPTURE(machine.preset, beyond_m, ahead_m, aside_m);
    const auto turn = ground.turn(aside_m, ahead_m);
    const auto ahead = ground.all(aside_m, ahead_m, true);
    const auto others = ground.all(aside_m, ahead_m, false);
    CHECK((turn.has_value() || ahead.empty() || others.empty()));
    if (!turn) continue;
    const double time = turn_time_s(*turn, machine);
    for (const Path& other : others) CHECK(time <= turn_time_s(other, machine) + 1e-5);
    if (pivots(*turn) || reverses(*turn))
      for (const Path& other : ahead)
        CHECK((time <= turn_time_s(other, machine) || length_m(other) > length_m(*turn)));
  }
}

TEST_CASE("a turn soon found goes forwards where one does, and is found where any is", "[route][turn]") {
  const Machine machine = preset(GENERATE("robot-3m", "husky", "tractor-6m"));
  const double beyond_m = GENERATE(30.0, 9.0, 5.0, 1.5);
  const Ground ground{machine, beyond_m};
  int soon_ones = 0;
  for (const double aside_m : {1.0, 3.0, 7.0, 20.0})
    for (const double heading_rad : {0.0, 1.0, -2.0, kPi}) {
      CAPTURE(machine.preset, beyond_m, aside_m, heading_rad);
      const Pose to{{-3, aside_m}, heading_rad};
      const auto soon = ground.turn_soon(to);
      const auto fastest = ground.turn(to);
      REQUIRE(soon.has_value() == fastest.has_value());
      if (!soon) continue;
      ++soon_ones;
      CHECK(turn_time_s(*fastest, machine) <= turn_time_s(*soon, machine) + 1e-5);
      if (!reverses(*fastest) && !pivots(*fastest)) CHECK(length_m(*soon) == length_m(*fastest));
      CHECK(distance_m(end_pose(*soon).at, to.at) < 1e-9);
    }
  CHECK((beyond_m < 9 || soon_ones > 3));  // there is room
}

TEST_CASE("a turn soon found stops where none forwards is short enough", "[route][turn]") {
  const Ground ground{preset("robot-3m"), 5.6};
  const Pose beside{{0, 3}, kPi};
  const auto fastest = ground.turn(beside);
  REQUIRE(fastest);
  REQUIRE(reverses(*fastest));
  const auto soon = ground.turn_soon(beside, length_m(*fastest) + 0.1);
  REQUIRE(soon);
  CHECK(reverses(*soon));
  CHECK(ground.costs_m(*soon) >= ground.least_with_stop_m(beside));
}

TEST_CASE("a machine turns about on ground too shallow for a loop, if it may reverse or pivot",
          "[route][turn]") {
  Machine robot = preset("robot-3m");
  const double shallow_m = 5.6;  // its body reaches 2.4 m ahead
  const auto turn = Ground{robot, shallow_m}.turn(3, 0);
  REQUIRE(turn);
  CHECK(reverses(*turn));
  robot.may_reverse = false;
  const auto forwards = Ground{robot, shallow_m}.turn(3, 0);
  CHECK((!forwards || length_m(*forwards) > 2 * length_m(*turn)));

  Machine husky = preset("husky");
  const auto about = Ground{husky, 0.7}.turn(0.75, 0);
  REQUIRE(about);
  CHECK(pivots(*about));
  husky.may_pivot = false;
  const auto otherwise = Ground{husky, 0.7}.turn(0.75, 0);
  CHECK((!otherwise || !pivots(*otherwise)));
}
