// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "selion/motion/timed_turn.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

bool anywhere(const Path&) { return true; }

/// From the end of a swath to the start of the one `aside_m` to its left.
Pose beside(double aside_m) { return {{0, aside_m}, std::numbers::pi}; }

Machine paper_robot() {
  Machine m;
  for (const MachinePreset& preset : machine_presets())
    if (preset.name == "p3") m = preset.machine;
  m.working_width_m = 4;
  m.max_steer_deg = 18;
  return m;
}

struct Saving {
  double aside_m = 0;
  double planned_mps = 0;
  double at_cap_s = 0;
  double best_s = 0;

  [[nodiscard]] double share() const { return 1 - best_s / at_cap_s; }
};

}  // namespace

TEST_CASE("a turn costs its own time and what braking and gaining speed lose", "[motion][timed_turn]") {
  Machine m;
  m.work_speed_mps = 2;
  m.max_speed_mps = 2;
  m.turn_speed_mps = 1;
  const Path ahead{{{{}, 0, 0, 0, 10}}};
  CHECK(turn_time_s(ahead, m) == Approx(5));
  // from 2 to 1 m/s at .5 m/s2: 2 s for 3 m instead of 1.5 s, and again after it
  const Path arc{{{{}, 0, 0.1, 0, 7}}};
  CHECK(turn_time_s(arc, m) == Approx(7 + 0.5 + 0.5));
}

TEST_CASE("the speeds for turns start at the cap and fall", "[motion][timed_turn]") {
  for (const MachinePreset& preset : machine_presets()) {
    CAPTURE(preset.name);
    const std::vector<double> speeds = turn_speeds(preset.machine);
    REQUIRE(!speeds.empty());
    REQUIRE(speeds.size() <= 10);
    CHECK(speeds.front() == preset.machine.turn_speed_mps);
    for (std::size_t i = 1; i < speeds.size(); ++i) CHECK(speeds[i] == Approx(0.75 * speeds[i - 1]));
    const CurveLimits slowest = limits_at(preset.machine, speeds.back());  // clothoid by radius
    const double clothoid = slowest.curvature_per_m * slowest.curvature_per_m / slowest.sharpness_per_m2;
    CHECK((speeds.size() == 1 || (clothoid >= 0.1 && clothoid < 0.1 / 0.74)));
  }
  Machine odd;
  odd.max_steer_deg = 89;
  odd.wheelbase_m = 0.05;
  CHECK(turn_speeds(odd).size() == 10);
}

TEST_CASE("the speed for turns between swaths is the cap unless steering is slow", "[motion][timed_turn]") {
  for (const MachinePreset& preset : machine_presets()) {
    CAPTURE(preset.name);
    const Machine& m = preset.machine;
    CHECK(swath_turn_speed_mps(m, m.working_width_m) == m.turn_speed_mps);
  }
  const double cap_mps = GENERATE(2.0, 3.0, 5.0, 8.0);
  Machine slow_steering;
  slow_steering.max_steer_rate_deg_s = 15;
  slow_steering.max_lateral_mps2 = 2;
  slow_steering.work_speed_mps = 2;
  slow_steering.max_speed_mps = slow_steering.turn_speed_mps = cap_mps;
  const auto time_at_s = [&](double speed_mps) {
    const auto turns = connections({}, beside(3), limits_at(slow_steering, speed_mps));
    REQUIRE(!turns.empty());
    return turn_time_s(turns.front(), slow_steering);
  };
  const double chosen_mps = swath_turn_speed_mps(slow_steering, 3);
  CHECK(chosen_mps <= cap_mps);
  CHECK((cap_mps < 3 || chosen_mps < cap_mps));
  for (double share = 1; share > 0.1; share *= 0.97)
    CHECK(time_at_s(chosen_mps) <= 1.01 * time_at_s(share * cap_mps));
}

TEST_CASE("no turn of any speed is faster than the fastest", "[motion][timed_turn]") {
  const Machine m = machine_presets()[GENERATE(0U, 1U, 2U, 4U)].machine;
  const Pose to = GENERATE(Pose{{0, 3}, std::numbers::pi}, Pose{{4, -7}, -2.5}, Pose{{12, 3}, 0.4});
  CAPTURE(m.preset, to.at.x_m);
  const std::vector<double> speeds = turn_speeds(m);

  const auto best = fastest_turn({}, to, m, speeds, anywhere);

  REQUIRE(best.has_value());
  CHECK(best->time_s == Approx(turn_time_s(best->path, m)).epsilon(1e-12));
  CHECK(distance_m(end_pose(best->path).at, to.at) < 1e-8);
  for (const double speed : speeds)
    for (const Path& path : connections({}, to, limits_at(m, speed)))
      CHECK(turn_time_s(path, m) >= best->time_s * (1 - 1e-12));
}

TEST_CASE("a longer turn that is straighter may be the fastest", "[motion][timed_turn]") {
  Machine m;
  m.max_speed_mps = 8;
  m.turn_speed_mps = 0.4;
  m.max_accel_mps2 = m.max_brake_mps2 = 4;
  const std::vector<double> cap{m.turn_speed_mps};
  int longer = 0;
  std::mt19937 random{3};
  std::uniform_real_distribution<double> any{-1, 1};
  for (int i = 0; i < 60; ++i) {
    const Pose to{{12 * any(random), 12 * any(random)}, std::numbers::pi * any(random)};
    const auto best = fastest_turn({}, to, m, cap, anywhere);
    REQUIRE(best.has_value());
    const std::vector<Path> all = connections({}, to, limits_at(m, m.turn_speed_mps));
    for (const Path& path : all) CHECK(turn_time_s(path, m) >= best->time_s * (1 - 1e-12));
    if (length_m(best->path) > length_m(all.front()) + 1e-6) ++longer;
  }
  CHECK(longer > 0);
}

TEST_CASE("only a turn that stays inside is taken", "[motion][timed_turn]") {
  const Machine m;
  const std::vector<double> speeds = turn_speeds(m);
  const Pose to = beside(3);
  const auto free = fastest_turn({}, to, m, speeds, anywhere);
  REQUIRE(free.has_value());
  const auto other = fastest_turn({}, to, m, speeds, [&](const Path& path) { return path != free->path; });
  REQUIRE(other.has_value());
  CHECK(other->path != free->path);
  CHECK(other->time_s >= free->time_s);
  CHECK(!fastest_turn({}, to, m, speeds, [](const Path&) { return false; }).has_value());
}

// Prints a table of docs/evidence.md: selion_tests "time saved*"
TEST_CASE("time saved by choosing the turn speed", "[.][timed_turn]") {
  std::vector<Machine> machines{paper_robot()};
  machines.front().preset = "p3, 4 m, 18 deg";
  for (const MachinePreset& preset : machine_presets()) machines.push_back(preset.machine);
  std::printf("%-16s %10s | %28s | %30s\n", "", "turn speed", "to the next swath: at cap, best",
              "where it saves most: aside, at");
  for (const Machine& m : machines) {
    const std::vector<double> cap{m.turn_speed_mps};
    const std::vector<double> speeds = turn_speeds(m);
    const auto saved = [&](double aside_m) {
      const auto at_cap = fastest_turn({}, beside(aside_m), m, cap, anywhere);
      const auto best = fastest_turn({}, beside(aside_m), m, speeds, anywhere);
      REQUIRE((at_cap && best));
      return Saving{aside_m, best->planned_mps, at_cap->time_s, best->time_s};
    };
    const Saving next = saved(m.working_width_m);
    Saving most = next;
    double sum = 0;
    constexpr int kWidths = 200;  // 0.02 to 4 turning radii
    for (int i = 1; i <= kWidths; ++i) {
      const Saving one = saved(0.02 * i / max_curvature_per_m(m));
      sum += one.share() / kWidths;
      if (one.share() > most.share()) most = one;
    }
    std::printf("%-16s %6.2f m/s | %7.3f s %7.3f s %6.2f %% | %6.2f m %5.2f m/s %6.2f %% mean %5.2f %%\n",
                m.preset.c_str(), m.turn_speed_mps, next.at_cap_s, next.best_s, 100 * next.share(),
                most.aside_m, most.planned_mps, 100 * most.share(), 100 * sum);
  }
}
