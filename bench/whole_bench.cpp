// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "fields.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

Plan planned(const Field& field, const Job& job) {
  auto plan = selion::plan(field, job, Repair::notes_only, no_progress);
  if (!plan) throw std::runtime_error{field.name + ": " + plan.error().reason};
  return *std::move(plan);
}

/// Largest memory that this process has held, MB; 0 where the system does not tell.
double peak_mb() {
  std::ifstream status{"/proc/self/status"};
  for (std::string word; status >> word;) {
    double kib = 0;
    if (word == "VmHWM:" && status >> kib) return kib * 1024 / 1e6;
  }
  return 0;
}

/// What the plan is worth. The ratio is the whole time over that of the covered ground at work speed.
void count(benchmark::State& state, const Plan& plan, const Machine& machine) {
  double area_m2 = 0;
  double covered_m2 = 0;
  double total_s = 0;
  for (const BlockReport& block : plan.blocks) {
    area_m2 += block.area_m2;
    covered_m2 += block.covered_m2;
    total_s += block.work_s + block.turn_s + block.transfer_s;
  }
  state.counters["covered_percent"] = 100 * covered_m2 / area_m2;
  state.counters["headland_m"] = plan.blocks.front().headland_depth_m;
  state.counters["time_ratio"] = total_s * machine.working_width_m * machine.work_speed_mps / covered_m2;
}

/// From the field in memory to the whole plan.
void plan_by(benchmark::State& state, const Field& field, const Job& job) {
  Plan plan;
  for (auto _ : state) {
    plan = planned(field, job);
    benchmark::DoNotOptimize(plan);
  }
  state.counters["peak_mb"] = peak_mb();
  count(state, plan, job.machine);
}

void plan_4m(benchmark::State& state, const std::string& name) {
  plan_by(state, field_named(name), four_metres());
}
BENCHMARK_CAPTURE(plan_4m, f1, "f1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f2, "f2")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f3, "f3")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f4, "f4")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f5, "f5")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_4m, f6, "f6")->Unit(benchmark::kMillisecond);

/// `range` corners.
void plan_wavy(benchmark::State& state) {
  plan_by(state, wavy_field(static_cast<int>(state.range(0))), four_metres());
}
BENCHMARK(plan_wavy)->Arg(100)->Arg(10'000)->Unit(benchmark::kMillisecond)->Iterations(1)->Repetitions(5);

void plan_square_kilometre(benchmark::State& state) { plan_by(state, square_kilometre(), one_metre()); }
BENCHMARK(plan_square_kilometre)->Unit(benchmark::kMillisecond)->Iterations(1)->Repetitions(3);

/// Of all processes started and ended so far.
double cpu_of_children_ms() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto ms = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3;
  };
  return ms(used.ru_utime) + ms(used.ru_stime);
}

/// The command as a person runs it, all files written: wall time.
void command(benchmark::State& state, const std::string& name) {
  const auto out = std::filesystem::temp_directory_path() / ("selion_bench_" + name);
  const std::string line = "'" SELION_COMMAND "' plan '" SELION_DATA_DIR "/fields/" + name +
                           ".geojson' -o '" + out.string() + "' -q --overwrite >/dev/null";
  const double before_ms = cpu_of_children_ms();
  for (auto _ : state) {
    if (std::system(line.c_str()) != 0) throw std::runtime_error{"this failed: " + line};
  }
  state.counters["cpu_ms"] =
      benchmark::Counter(cpu_of_children_ms() - before_ms, benchmark::Counter::kAvgIterations);
  std::filesystem::remove_all(out);
}
BENCHMARK_CAPTURE(command, f1, "f1")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(10);

}  // namespace
