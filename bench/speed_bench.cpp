// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>

#include "selion/motion/limits.hpp"
#include "selion/motion/timed_turn.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

/// 300 m swaths and U-turns 3 m aside, at least `count` legs; the turns planned at 1 m/s, driven below
/// `cap_mps`.
std::vector<Leg> field_legs(const Machine& machine, std::size_t count, double cap_mps) {
  std::vector<Leg> legs;
  Pose at;
  while (legs.size() < count) {
    const Pose end{placed(at, {300, 0}), at.heading_rad};
    legs.push_back({{line(at.at, end.at)}, machine.work_speed_mps, true, 0});
    const double aside = std::abs(at.heading_rad) < 1 ? 3 : -3;
    at = {placed(end, {0, aside}), aside > 0 ? std::numbers::pi : 0};
    const Path turn = connections(end, at, limits_at(machine, machine.turn_speed_mps)).front();
    for (const Stretch& stretch : turn) legs.push_back({stretch, cap_mps, false, 0});
  }
  return legs;
}

Machine nimble() {
  Machine m;
  m.max_accel_mps2 = m.max_brake_mps2 = 2;
  return m;
}

/// A field's drive: 1500 legs, some 12 000 samples. `cap_mps` 1: the cap rules; 3: steering and lateral
/// acceleration do.
void drive_a_field(benchmark::State& state) {
  const Machine m = nimble();
  const auto legs = field_legs(m, 1500, static_cast<double>(state.range(0)));
  std::size_t samples = 0;
  for (auto _ : state) {
    const auto driven = drive(legs, m);
    samples = driven.size();
    benchmark::DoNotOptimize(driven.data());
  }
  const auto rate = benchmark::Counter::kIsIterationInvariantRate;
  state.counters["legs/s"] = benchmark::Counter(static_cast<double>(legs.size()), rate);
  state.counters["samples/s"] = benchmark::Counter(static_cast<double>(samples), rate);
  state.counters["samples"] = static_cast<double>(samples);
}
BENCHMARK(drive_a_field)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

/// Without the samples.
void time_a_field(benchmark::State& state) {
  const Machine m = nimble();
  const auto legs = field_legs(m, 1500, static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(duration_s(legs, m, EndSpeeds{}));
  state.counters["legs/s"] =
      benchmark::Counter(static_cast<double>(legs.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(time_a_field)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

/// One U-turn, `cap_mps` as above.
void time_a_turn(benchmark::State& state) {
  const Machine m = nimble();
  const double cap = static_cast<double>(state.range(0));
  auto legs = field_legs(m, 2, cap);
  legs.erase(legs.begin());
  for (auto _ : state) benchmark::DoNotOptimize(duration_s(legs, m, EndSpeeds{1.5, 1.5}));
  state.counters["curves"] = static_cast<double>(legs.size());
}
BENCHMARK(time_a_turn)->Arg(1)->Arg(3)->Unit(benchmark::kNanosecond);

void use_of_limits(benchmark::State& state) {
  const Machine m = nimble();
  const auto legs = field_legs(m, 1500, 3);
  const auto samples = drive(legs, m);
  for (auto _ : state) benchmark::DoNotOptimize(limit_use(legs, samples, m));
}
BENCHMARK(use_of_limits)->Unit(benchmark::kMillisecond);

void choose_a_turn(benchmark::State& state) {
  const Machine m;
  const auto speeds = turn_speeds(m);
  const double aside = static_cast<double>(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        fastest_turn({}, {{0, aside}, std::numbers::pi}, m, speeds, [](const Path&) { return true; }));
}
BENCHMARK(choose_a_turn)->Arg(3)->Arg(6)->Unit(benchmark::kMicrosecond);

}  // namespace
