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

/// All pairs of 64 headings over a chord of 1 m.
std::vector<Pose> headings() {
  std::vector<Pose> all;
  for (int i = 1; i <= 64; ++i) all.push_back({{}, std::numbers::pi * (i - 32) / 32});
  return all;
}

/// At hundredths.
void fresnel_at(benchmark::State& state) {
  double t = static_cast<double>(state.range(0)) / 100;
  for (auto _ : state) {
    benchmark::DoNotOptimize(t);
    benchmark::DoNotOptimize(fresnel(t));
  }
}
BENCHMARK(fresnel_at)->Arg(10)->Arg(50)->Arg(100)->Arg(200)->Arg(350)->Arg(500)->Arg(2000)->Arg(100000);

/// Everywhere within the reach.
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

void one_clothoid_on_grid(benchmark::State& state) {
  const auto poses = headings();
  std::size_t i = 0;
  for (auto _ : state) {
    const Pose to{{1, 0}, poses[i / 64 % 64].heading_rad};
    benchmark::DoNotOptimize(clothoid_between(poses[i % 64], to));
    ++i;
  }
}
BENCHMARK(one_clothoid_on_grid);

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

/// Curves of 10 m that all but overlap, 10^-n m apart.
void near_overlap(benchmark::State& state) {
  const Curve curve{{1, 2}, 0.3, -0.4, 0.08, 10};
  Curve other = curve;
  other.start.y_m += std::pow(10.0, -static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(crossings(curve, other));
}
BENCHMARK(near_overlap)->Arg(4)->Arg(6)->Arg(8)->Arg(9)->Unit(benchmark::kMillisecond);

void offset_bend(benchmark::State& state) {
  const auto curves = any_curves();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(largest_bend(OffsetCurve{curves[i++ % kMany], 0.3}));
}
BENCHMARK(offset_bend);

}  // namespace
