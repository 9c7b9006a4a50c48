// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

namespace selion {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// One row of the table: a benchmark's time (where no counter is named) or one of its counters.
struct Figure {
  std::string_view what;
  std::string_view benchmark;
  std::string_view counter;
  std::string_view unit;
  double least = -kNone;
  double most = kNone;
};

constexpr auto kFigures = std::to_array<Figure>({
    {"Fresnel pair", "fresnel_pair/50", "", "ns", -kNone, 50},
    {"one clothoid between poses", "one_clothoid", "", "us", -kNone, 0.5},
    {"three clothoids between bent poses", "three_clothoids", "", "us"},
    {"U-turn, loop", "u_turn_of/loop", "", "us", -kNone, 0.5},
    {"U-turn, dip", "u_turn_of/dip", "", "us", -kNone, 0.5},
    {"U-turn, flat", "u_turn_of/flat", "", "us", -kNone, 0.5},
    {"shortest U-turn of all families, w = 2 m", "u_turn/paper/20", "", "us"},
    {"the same, w = 7.6 m", "u_turn/paper/76", "", "us"},
    {"the same, w = 8 m", "u_turn/paper/80", "", "us"},
    {"its length at w = 2 m", "u_turn/paper/20", "length_m", "m", 25.15105, 25.15107},
    {"at w = 6 m", "u_turn/paper/60", "length_m", "m", 18.61869, 18.61871},
    {"at w = 8 m", "u_turn/paper/80", "length_m", "m", 12.639665, 12.639675},
    {"steering slowly, w = 4 m: length", "u_turn/slow/40", "length_m", "m", 22.745, 22.775},
    {"the same: depth", "u_turn/slow/40", "depth_m", "m", 8.885, 8.905},
    {"U-turns, w = .05 to 14 m: each", "u_turns/paper", "", "us"},
    {"the same: worst, times Dubins", "u_turns/paper", "worst_ratio", "", -kNone, 1.06},
    {"the same: mean", "u_turns/paper", "mean_ratio", "", -kNone, 1.03},
    {"steering slowly: worst", "u_turns/slow", "worst_ratio", ""},
    {"steering slowly: mean", "u_turns/slow", "mean_ratio", ""},
    {"10 000 random pose pairs in 10 m by 10 m: each", "any_poses/paper", "", "us"},
    {"the same: solved", "any_poses/paper", "solved_percent", "%", 100, kNone},
    {"the same: worst end error", "any_poses/paper", "end_error_m", "m", -kNone, 1e-12},
    {"the same: longer than 1.5 times Dubins", "any_poses/paper", "long_percent", "%", -kNone, 1},
    {"the same: mean, times Dubins", "any_poses/paper", "mean_ratio", ""},
    {"the same: worst, times Dubins", "any_poses/paper", "worst_ratio", ""},
    {"Dubins' length of each", "dubins", "", "us"},
    {"steering slowly: each", "any_poses/slow", "", "us"},
    {"steering slowly: longer than 1.5 times Dubins", "any_poses/slow", "long_percent", "%"},
    {"steering slowly: worst, times Dubins", "any_poses/slow", "worst_ratio", ""},
    {"speed profile with samples", "drive_a_field/1", "legs/s", "legs/s"},
    {"the same where steering rules", "drive_a_field/3", "legs/s", "legs/s"},
    {"timing one turn", "time_a_turn/1", "", "ns"},
    {"the same where steering rules", "time_a_turn/3", "", "ns"},
    {"plan(), F1, 4 m", "plan_4m/f1", "", "ms", -kNone, 20},
    {"plan(), F2, 4 m", "plan_4m/f2", "", "ms", -kNone, 20},
    {"plan(), F3, 4 m", "plan_4m/f3", "", "ms", -kNone, 20},
    {"plan(), F4, 4 m", "plan_4m/f4", "", "ms", -kNone, 20},
    {"plan(), F5, 4 m", "plan_4m/f5", "", "ms", -kNone, 20},
    {"plan(), F6, 4 m", "plan_4m/f6", "", "ms", -kNone, 20},
    {"F1: covered", "plan_4m/f1", "covered_percent", "%", 99.6, kNone},
    {"F2: covered", "plan_4m/f2", "covered_percent", "%", 99.7, kNone},
    {"F3: covered", "plan_4m/f3", "covered_percent", "%", 99.6, kNone},
    {"F4: covered", "plan_4m/f4", "covered_percent", "%", 99.8, kNone},
    {"F5: covered", "plan_4m/f5", "covered_percent", "%", 99.6, kNone},
    {"F6: covered", "plan_4m/f6", "covered_percent", "%", 99.3, kNone},
    {"F1: whole time over that of the ground covered", "plan_4m/f1", "time_ratio", "", -kNone, 1.23},
    {"F2: the same", "plan_4m/f2", "time_ratio", "", -kNone, 1.24},
    {"F3: the same", "plan_4m/f3", "time_ratio", "", -kNone, 1.19},
    {"F4: the same", "plan_4m/f4", "time_ratio", "", -kNone, 1.21},
    {"F5: the same", "plan_4m/f5", "time_ratio", "", -kNone, 1.29},
    {"F6: the same", "plan_4m/f6", "time_ratio", "", -kNone, 1.35},
    {"plan(), 20 ha, border of 100 corners, 4 m", "plan_wavy/100", "", "ms"},
    {"plan(), 20 ha, border of 10 000 corners, 4 m", "plan_wavy/10000", "", "ms", -kNone, 500},
    {"the same: covered", "plan_wavy/10000", "covered_percent", "%"},
    {"plan(), 1 km by 1 km, six holes, 1 m", "plan_square_kilometre", "", "ms", -kNone, 1000},
    {"the same: peak memory of the process", "plan_square_kilometre", "peak_mb", "MB", -kNone, 200},
    {"the same: covered", "plan_square_kilometre", "covered_percent", "%"},
    {"selion plan F1, default machine, all files: wall time", "command/f1", "", "ms", -kNone, 150},
    {"the same: time of the processor", "command/f1", "cpu_ms", "ms"},
    {"selion batch, 4854 Dutch fields, two threads: planned and written a second", "batch_dutch/planned",
     "fields_per_s", "", 150, kNone},
    {"the same: fields a second of the processor", "batch_dutch/planned", "fields_per_cpu_s", ""},
    {"the same: peak memory", "batch_dutch/planned", "peak_mb", "MB", -kNone, 300},
    {"planned, written and verified a second", "batch_dutch/verified", "fields_per_s", "", 60, kNone},
    {"the same: fields a second of the processor", "batch_dutch/verified", "fields_per_cpu_s", ""},
    {"the same: peak memory", "batch_dutch/verified", "peak_mb", "MB", -kNone, 300},
});

/// Keeps what was measured, by benchmark.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const std::string& arguments = run.run_name.args;
      runs_[run.run_name.function_name + (arguments.empty() ? "" : "/" + arguments)].push_back(run);
    }
    if (!runs.empty()) std::cerr << "measured " << runs.front().run_name.str() << '\n';
  }

  [[nodiscard]] std::vector<double> values(const Figure& figure) const {
    std::vector<double> all;
    const auto found = runs_.find(std::string{figure.benchmark});
    if (found == runs_.end()) return all;
    for (const Run& run : found->second) {
      all.push_back(figure.counter.empty() ? time_of(run, figure.unit)
                                           : run.counters.at(std::string{figure.counter}).value);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  /// Of the processor, but wall time where the benchmark asks for it.
  static double time_of(const Run& run, std::string_view unit) {
    const double time =
        run.run_name.time_type == "real_time" ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
    const double time_s = time / benchmark::GetTimeUnitMultiplier(run.time_unit);
    return time_s * (unit == "ns" ? 1e9 : unit == "us" ? 1e6 : 1e3);
  }

  std::map<std::string, std::vector<Run>> runs_;
};

/// `digits` significant ones, no powers of ten between 1e-4 and 1e7.
std::string text(double value, int digits) {
  std::ostringstream out;
  if (std::abs(value) >= std::pow(10, digits) && std::abs(value) < 1e7)
    out << std::fixed << std::setprecision(0);
  else
    out << std::setprecision(digits);
  out << value;
  return out.str();
}

std::string limit_of(const Figure& figure) {
  if (figure.most < kNone && figure.least > -kNone)
    return text(figure.least, 7) + " to " + text(figure.most, 7);
  if (figure.most < kNone) return "at most " + text(figure.most, 7);
  if (figure.least > -kNone) return "at least " + text(figure.least, 7);
  return "none";
}

/// What comes out the same each time is printed once: lengths in full, shares and ratios to four digits.
std::string measured(const std::vector<double>& values, std::string_view unit) {
  if (values.empty()) return "not measured";
  const std::string after = unit.empty() ? "" : " " + std::string{unit};
  const double median = values[values.size() / 2];
  if (values.front() == values.back()) return text(median, unit == "m" ? 7 : 4) + after;
  return text(median, 3) + after + " (" + text(values.front(), 3) + " to " + text(values.back(), 3) + ")";
}

void print(std::ostream& out, const Figure& figure, const Collector& collected) {
  const std::vector<double> values = collected.values(figure);
  const double median = values.empty() ? kNone : values[values.size() / 2];
  const bool met = median >= figure.least && median <= figure.most;
  out << "| " << figure.what << " | " << measured(values, figure.unit) << " | " << limit_of(figure)
      << (met ? "" : ": **missed**") << " | " << figure.benchmark << (figure.counter.empty() ? "" : ", ")
      << figure.counter << " |\n";
}

}  // namespace

void print_figures(std::ostream& out) {
  // The peak of memory is one of the whole process: what needs most goes first.
  const std::string first = "plan_square_kilometre";
  std::string others = "^(";
  for (const Figure& figure : kFigures) {
    if (figure.benchmark != first) others.append(figure.benchmark) += '|';
  }
  others.back() = ')';
  Collector collected;
  benchmark::RunSpecifiedBenchmarks(&collected, "^" + first);
  benchmark::RunSpecifiedBenchmarks(&collected, others + "(/[a-z_]+(:[0-9]+)?)*$");

  out << "| figure | measured: median (least to most) | limit | benchmark |\n|---|---|---|---|\n";
  for (const Figure& figure : kFigures) print(out, figure, collected);
}

}  // namespace selion
