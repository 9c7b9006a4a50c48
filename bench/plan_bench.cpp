// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <stdexcept>
#include <string>

#include <benchmark/benchmark.h>

#include "selion/field/read.hpp"
#include "selion/plan/plan.hpp"

namespace {

selion::Field field_named(const std::string& name) {
  return selion::read_fields(SELION_DATA_DIR "/fields/" + name + ".geojson", {}, std::cin).front();
}

/// From the field in memory to the whole plan, by the default machine.
void plan_field(benchmark::State& state, const std::string& name) {
  const selion::Field field = field_named(name);
  for (auto _ : state) {
    auto plan = selion::plan(field, {}, selion::Repair::notes_only, selion::no_progress);
    if (!plan) throw std::runtime_error{name + ": " + plan.error().reason};
    benchmark::DoNotOptimize(plan);
  }
}

/// The paper's robots as one machine 4 m wide, forwards only (docs/performance.md).
selion::Job four_metres() {
  selion::Job job;
  selion::Machine& m = job.machine;
  for (const selion::MachinePreset& preset : selion::machine_presets())
    if (preset.name == "p3") m = preset.machine;
  m.working_width_m = m.body_width_m = 4;
  m.max_steer_deg = 18;
  m.front_m = 2.4;
  m.rear_m = 0.6;
  m.max_lateral_mps2 = 1.5;
  m.work_speed_mps = 3.5;
  m.may_reverse = false;
  job.field.edge_margin_m = job.field.obstacle_clearance_m = 0.05;
  return job;
}

void plan_4m(benchmark::State& state, const std::string& name) {
  const selion::Field field = field_named(name);
  const selion::Job job = four_metres();
  for (auto _ : state) {
    auto plan = selion::plan(field, job, selion::Repair::notes_only, selion::no_progress);
    if (!plan) throw std::runtime_error{name + ": " + plan.error().reason};
    benchmark::DoNotOptimize(plan);
  }
}
BENCHMARK_CAPTURE(plan_4m, f1, "f1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f2, "f2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f3, "f3")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f4, "f4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f5, "f5")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f6, "f6")->Unit(benchmark::kMillisecond);

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
