// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "selion/motion/dubins.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

// Of Cariou et al. 2020: loop below 7.41 m, dip below 7.83 m, else flat; and the same robot at 18 degrees of
// steering and 2 m/s.
constexpr CurveLimits kPaper{0.27, 0.65};
constexpr CurveLimits kSlow{0.271, 0.327};

struct Pair {
  Pose from;
  Pose to;
};

Pair swaths(double aside_m) { return {{}, {{0, aside_m}, std::numbers::pi}}; }

/// The pairs that the tests use, too.
std::vector<Pair> pairs_in_ten_metres(int count) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> place{0, 10};
  std::uniform_real_distribution<double> heading{-std::numbers::pi, std::numbers::pi};
  std::vector<Pair> all;
  for (int i = 0; i < count; ++i) {
    const Pose from{{place(random), place(random)}, heading(random)};
    all.push_back({from, {{place(random), place(random)}, heading(random)}});
  }
  return all;
}

std::optional<Path> shortest(const Pair& pair, const Swings& swings) {
  return Connections{pair.from, pair.to, swings}.next();
}

double times_dubins(const Path& path, const Pair& pair, const CurveLimits& limits) {
  return length_m(path) / dubins_length_m(pair.from, pair.to, 1 / limits.curvature_per_m);
}

/// How far the axle gets ahead of where it started.
double depth_m(const Path& path) {
  double depth = 0;
  for (const Pose& pose : poses(path, 0.001)) depth = std::max(depth, pose.at.x_m);
  return depth;
}

/// The shortest way between swaths `range` tenths of a metre apart, whatever family it takes.
void u_turn(benchmark::State& state, const CurveLimits& limits) {
  const Pair pair = swaths(static_cast<double>(state.range(0)) / 10);
  const Swings swings{limits};
  for (auto _ : state) benchmark::DoNotOptimize(shortest(pair, swings));
  const Path turn = *shortest(pair, swings);
  state.counters["length_m"] = length_m(turn);
  state.counters["depth_m"] = depth_m(turn);
}
BENCHMARK_CAPTURE(u_turn, paper, kPaper)->Arg(20)->Arg(60)->Arg(76)->Arg(80)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(u_turn, slow, kSlow)->Arg(40)->Unit(benchmark::kMicrosecond);

/// One U-turn of the family that it takes, solved and drawn.
void u_turn_of(benchmark::State& state, std::string_view name, double aside_m) {
  const Swings swings{kPaper};
  const Pair pair = swaths(aside_m);
  for (const TurnKind& kind : turns()) {
    if (kind.name != name) continue;
    for (auto _ : state) benchmark::DoNotOptimize(kind.candidates(pair.from, pair.to, swings));
  }
}
BENCHMARK_CAPTURE(u_turn_of, loop, "loop", 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(u_turn_of, dip, "dip", 7.6)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(u_turn_of, flat, "flat", 9)->Unit(benchmark::kMicrosecond);

/// The shortest ways of all pairs: microseconds for each, and how they compare with Dubins' curves.
void all_of(benchmark::State& state, const std::vector<Pair>& pairs, const CurveLimits& limits) {
  const Swings swings{limits};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(shortest(pairs[i++ % pairs.size()], swings));
  int solved = 0;
  int long_ways = 0;
  double sum = 0;
  double worst = 0;
  double off_m = 0;
  for (const Pair& pair : pairs) {
    const auto path = shortest(pair, swings);
    if (!path) continue;
    ++solved;
    const double ratio = times_dubins(*path, pair, limits);
    sum += ratio;
    worst = std::max(worst, ratio);
    long_ways += ratio > 1.5 ? 1 : 0;
    off_m = std::max(off_m, distance_m(end_pose(*path).at, pair.to.at));
  }
  const auto count = static_cast<double>(pairs.size());
  state.counters["solved_percent"] = 100 * solved / count;
  state.counters["long_percent"] = 100 * long_ways / count;
  state.counters["mean_ratio"] = sum / solved;
  state.counters["worst_ratio"] = worst;
  state.counters["end_error_m"] = off_m;
}

void u_turns(benchmark::State& state, const CurveLimits& limits) {
  std::vector<Pair> pairs;
  for (int i = 1; i <= 280; ++i) pairs.push_back(swaths(0.05 * i));
  all_of(state, pairs, limits);
}
BENCHMARK_CAPTURE(u_turns, paper, kPaper)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(u_turns, slow, kSlow)->Unit(benchmark::kMicrosecond);

void any_poses(benchmark::State& state, const CurveLimits& limits) {
  all_of(state, pairs_in_ten_metres(10'000), limits);
}
BENCHMARK_CAPTURE(any_poses, paper, kPaper)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(any_poses, slow, kSlow)->Unit(benchmark::kMicrosecond);

void dubins(benchmark::State& state) {
  const auto pairs = pairs_in_ten_metres(10'000);
  std::size_t i = 0;
  for (auto _ : state) {
    const Pair& pair = pairs[i++ % pairs.size()];
    benchmark::DoNotOptimize(dubins_length_m(pair.from, pair.to, 1 / kPaper.curvature_per_m));
  }
}
BENCHMARK(dubins);

}  // namespace
