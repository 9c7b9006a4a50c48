// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>
#include <string>

#include <benchmark/benchmark.h>

#include "fields.hpp"
#include "selion/plan/plan.hpp"

namespace {

using selion::field_named;

/// From the field in memory to the whole plan, by the default machine.
void plan_field(benchmark::State& state, const std::string& name) {
  const selion::Field field = field_named(name);
  for (auto _ : state) {
    auto plan = selion::plan(field, {}, selion::Repair::notes_only, selion::no_progress);
    if (!plan) throw std::runtime_error{name + ": " + plan.error().reason};
    benchmark::DoNotOptimize(plan);
  }
}

void read_file(benchmark::State& state, const std::string& name) {
  for (auto _ : state) benchmark::DoNotOptimize(field_named(name));
}

BENCHMARK_CAPTURE(read_file, f1, "f1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, f1, "f1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, f2, "f2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, f3, "f3")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, f4, "f4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, f5, "f5")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, f6, "f6")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, with_pond, "with_pond")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_field, u_shape, "u_shape")->Unit(benchmark::kMillisecond);

}  // namespace
