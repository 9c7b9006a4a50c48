// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <random>

#include <benchmark/benchmark.h>

#include "selion/motion/speed.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

constexpr CurveLimits kRobot{0.556, 0.436};  // the 3 m robot at 1 m/s

/// Pairs of poses at distances that grow evenly by their order of magnitude up to `reach_m`, from a hundredth
/// of it.
std::vector<Pose> poses_within(double reach_m) {
  std::mt19937 random{5};
  std::uniform_real_distribution<double> any{-1, 1};
  std::vector<Pose> all;
  for (int i = 0; i < 1024; ++i) {
    const double reach = reach_m * std::pow(10, -2 * std::abs(any(random)));
    all.push_back({reach * Point{any(random), any(random)}, std::numbers::pi * any(random)});
  }
  return all;
}

void state_of(benchmark::State& state, const Curve& curve) {
  double s = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(state_at(curve, s));
    s = s < curve.length_m ? s + 0.01 : 0;
  }
}
BENCHMARK_CAPTURE(state_of, line, Curve{{1, 2}, 0.3, 0, 0, 10});
BENCHMARK_CAPTURE(state_of, arc, Curve{{1, 2}, 0.3, 0.2, 0, 10});
BENCHMARK_CAPTURE(state_of, clothoid_of_a_turn, Curve{{1, 2}, 0.3, 0, 0.436, 1.27});
BENCHMARK_CAPTURE(state_of, clothoid_of_many_turns, Curve{{1, 2}, 0.3, 0, 0.01, 100});

void connecting(benchmark::State& state) {
  const auto goals = poses_within(static_cast<double>(state.range(0)));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(connections({{0, 0}, 0}, goals[i++ % goals.size()], kRobot));
}
BENCHMARK(connecting)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

/// Only the shortest way, as the planner mostly wants it.
void first_connection(benchmark::State& state) {
  const auto goals = poses_within(static_cast<double>(state.range(0)));
  const Swings swings{kRobot};
  std::size_t i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(Connections{{{0, 0}, 0}, goals[i++ % goals.size()], swings}.next());
}
BENCHMARK(first_connection)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

void family(benchmark::State& state, TurnFamily candidates) {
  const auto goals = poses_within(10);
  const Swings swings{kRobot};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(candidates({{0, 0}, 0}, goals[i++ % goals.size()], swings));
}
const bool kFamiliesListed = [] {
  for (const TurnKind& kind : turns()) {
    benchmark::RegisterBenchmark(std::string{"family/"}.append(kind.name).c_str(), family, kind.candidates)
        ->Unit(benchmark::kMicrosecond);
  }
  return true;
}();

/// 300 m swaths and their U-turns, as many as make `range` legs.
void driving(benchmark::State& state) {
  std::vector<Leg> legs;
  Pose at;
  while (static_cast<long>(legs.size()) < state.range(0)) {
    const Pose end{placed(at, {300, 0}), at.heading_rad};
    legs.push_back({{line(at.at, end.at)}, 1.5, true});
    const double aside = std::abs(at.heading_rad) < 1 ? 3 : -3;
    at = {placed(end, {0, aside}), aside > 0 ? std::numbers::pi : 0};
    const Path turn = connections(end, at, kRobot).front();
    for (const Stretch& stretch : turn) legs.push_back({stretch, 1});
  }
  for (auto _ : state) benchmark::DoNotOptimize(drive(legs, Machine{}));
  state.SetItemsProcessed(state.iterations() * static_cast<long>(legs.size()));
}
BENCHMARK(driving)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
