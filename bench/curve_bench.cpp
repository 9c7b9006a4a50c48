// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "motion/fresnel.hpp"
#include "selion/motion/clothoid.hpp"
#include "selion/motion/crossing.hpp"
#include "selion/motion/nearest.hpp"
#include "selion/motion/offset.hpp"

using namespace selion;

namespace {

constexpr std::size_t kMany = 4096;

/// Poses in a square of 200 m, headed anyhow, and bends up to 0.3/m.
std::vector<BentPose> any_poses() {
  std::mt19937 random{5};
  std::uniform_real_distribution<double> any{-1, 1};
  std::vector<BentPose> all;
  for (std::size_t i = 0; i < kMany; ++i)
    all.push_back(
        {{{100 * any(random), 100 * any(random)}, std::numbers::pi * any(random)}, 0.3 * any(random)});
  return all;
}

/// Clothoids of up to 10 m, curvature within 1/m, and some full turns.
std::vector<Curve> any_curves() {
  std::mt19937 random{6};
  std::uniform_real_distribution<double> any{-1, 1};
  std::vector<Curve> all;
  for (std::size_t i = 0; i < kMany; ++i) {
    const double length = 10 * std::abs(any(random));
    all.push_back(
        {{5 * any(random), 5 * any(random)}, 3 * any(random), any(random), any(random) / length, length});
  }
  return all;
}

void fresnel_pair(benchmark::State& state) {
  const auto reach = static_cast<double>(state.range(0));
  double t = -reach;
  for (auto _ : state) {
    benchmark::DoNotOptimize(fresnel(t));
    t = t < reach ? t + 0.0137 * reach : -reach;
  }
}
BENCHMARK(fresnel_pair)->Arg(1)->Arg(5)->Arg(50);

void state_of_any(benchmark::State& state) {
  const auto curves = any_curves();
  std::size_t i = 0;
  for (auto _ : state) {
    const Curve& curve = curves[i++ % kMany];
    benchmark::DoNotOptimize(state_at(curve, curve.length_m));
  }
}
BENCHMARK(state_of_any);

void one_clothoid(benchmark::State& state) {
  const auto poses = any_poses();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(clothoid_between(poses[i % kMany].pose, poses[(i + 1) % kMany].pose));
    ++i;
  }
}
BENCHMARK(one_clothoid);

void three_clothoids(benchmark::State& state) {
  const auto poses = any_poses();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(clothoids_between(poses[i % kMany], poses[(i + 1) % kMany]));
    ++i;
  }
}
BENCHMARK(three_clothoids)->Unit(benchmark::kMicrosecond);

void nearest_point(benchmark::State& state) {
  const auto curves = any_curves();
  const auto poses = any_poses();
  const double reach = static_cast<double>(state.range(0)) / 100;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(nearest_on(curves[i % kMany], reach * poses[i % kMany].pose.at));
    ++i;
  }
}
BENCHMARK(nearest_point)->Arg(10)->Arg(100);

void box(benchmark::State& state) {
  const auto curves = any_curves();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(box_of(curves[i++ % kMany]));
}
BENCHMARK(box);

void crossing(benchmark::State& state) {
  const auto curves = any_curves();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(crossings(curves[i % kMany], curves[(i + 1) % kMany]));
    ++i;
  }
}
BENCHMARK(crossing);

void offset_bend(benchmark::State& state) {
  const auto curves = any_curves();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(largest_bend(OffsetCurve{curves[i++ % kMany], 0.3}));
}
BENCHMARK(offset_bend);

}  // namespace
