// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

constexpr const char* kFields = SELION_SHARED_DIR "/fields/batch/fields_batch.gpkg";

/// Results in the journal of a batch.
double results_in(const fs::path& folder) {
  std::ifstream journal{folder / "journal" / "1-of-1.jsonl"};
  double lines = 0;
  for (std::string line; std::getline(journal, line);) lines += line.find("\"status\"") != std::string::npos;
  return lines;
}

/// Runs selion, in adjacent order along the best edge, and returns what it used. @throws std::runtime_error
/// where it fails.
rusage used_by(const fs::path& out, bool verified) {
  const pid_t child = fork();
  if (child == 0) {
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    execl(SELION_COMMAND, SELION_COMMAND, "batch", kFields, "--layer", "nl_waterland_brp2020", "--threads",
          "2", "--direction", "edge", "--route-order", "adjacent", "-q", "--overwrite", "-o", out.c_str(),
          verified ? nullptr : "--no-verify", nullptr);
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) != child || status != 0)
    throw std::runtime_error{"selion batch failed"};
  return used;
}

/// All fields of a landscape on two threads, planned and written, without maps: wall time.
void batch_dutch(benchmark::State& state, bool verified) {
  if (!fs::exists(kFields)) {
    state.SkipWithError("the fields are not there");
    return;
  }
  const fs::path out = fs::temp_directory_path() / "selion_bench_batch";
  rusage used{};
  double wall_s = 0;
  for (auto _ : state) {
    const auto started = std::chrono::steady_clock::now();
    used = used_by(out, verified);
    wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  }
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6;
  };
  const double fields = results_in(out);
  state.counters["fields_per_s"] = fields / wall_s;
  state.counters["fields_per_cpu_s"] = fields / (seconds(used.ru_utime) + seconds(used.ru_stime));
  state.counters["peak_mb"] = static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
  fs::remove_all(out);
}
BENCHMARK_CAPTURE(batch_dutch, planned, false)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(1);
BENCHMARK_CAPTURE(batch_dutch, verified, true)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Repetitions(1);

}  // namespace
