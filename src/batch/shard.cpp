// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/batch/shard.hpp"

#include <array>
#include <charconv>
#include <string_view>

#include "selion/core/error.hpp"

namespace selion {
namespace {

constexpr int kMost = 100'000;

std::optional<int> whole(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// How a scheduler tells a task which one it is. A name that is empty is a number that it does not tell.
struct Scheduler {
  std::string_view name;
  const char* index;
  const char* first;
  const char* last;
  const char* step;
  const char* count;
};

// Numbers count from `first` (0 for ranks) in steps.
constexpr auto kSchedulers = std::to_array<Scheduler>({
    {"a Slurm job array", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
     "SLURM_ARRAY_TASK_STEP", ""},
    {"a Grid Engine array", "SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE", ""},
    {"an LSF array", "LSB_JOBINDEX", "1", "LSB_JOBINDEX_END", "LSB_JOBINDEX_STEP", ""},
    {"a PBS array", "PBS_ARRAY_INDEX", "1", "", "", ""},
    {"an MPI rank", "OMPI_COMM_WORLD_RANK", "0", "", "", "OMPI_COMM_WORLD_SIZE"},
    {"an MPI rank", "PMI_RANK", "0", "", "", "PMI_SIZE"},
    {"a Slurm task", "SLURM_PROCID", "0", "", "", "SLURM_NTASKS"},
});

class Task {
 public:
  Task(const Scheduler& scheduler, const Environment& environment)
      : scheduler_{scheduler}, environment_{environment} {}

  /// Absent where this scheduler runs no task here. Some set the number of plain jobs too, to "undefined" or
  /// 0.
  [[nodiscard]] std::optional<Shard> shard(std::optional<int> count) const {
    const auto index = number(scheduler_.index);
    if (!index) return std::nullopt;
    // where the count is given, some tasks of an array may have been submitted again by themselves
    const int first = (count ? whole(scheduler_.first) : number(scheduler_.first)).value_or(1);
    const int step = count ? 1 : number(scheduler_.step).value_or(1);
    if (!count && (step < 1 || *index < first)) return std::nullopt;
    if (!count) count = count_from(first, step);
    if (!count)
      throw InputError{"--shard auto: " + std::string{scheduler_.name} +
                       " does not say how many tasks there are; give --shard auto/N"};
    return Shard{(*index - first) / step + 1, *count};
  }

 private:
  [[nodiscard]] std::optional<int> count_from(int first, int step) const {
    if (const auto count = number(scheduler_.count)) return count;
    const auto last = number(scheduler_.last);
    if (!last || *last < first) return std::nullopt;
    return (*last - first) / step + 1;
  }
  /// A name of the environment, or a number as it stands.
  [[nodiscard]] std::optional<int> number(const std::string& name) const {
    if (const auto constant = whole(name)) return constant;
    const auto text = name.empty() ? std::nullopt : environment_(name);
    return text ? whole(*text) : std::nullopt;
  }

  const Scheduler& scheduler_;
  const Environment& environment_;
};

Shard from_scheduler(std::optional<int> count, const Environment& environment) {
  for (const Scheduler& scheduler : kSchedulers)
    if (const auto shard = Task{scheduler, environment}.shard(count)) return *shard;
  throw InputError{"--shard auto: no scheduler has numbered this task; give --shard I/N"};
}

[[noreturn]] void refuse(const std::string& text) {
  throw InputError{"--shard: '" + text + "' is no share; write I/N with I from 1 to N, or auto"};
}

Shard parsed(const std::string& text, const Environment& environment) {
  const std::size_t slash = text.find('/');
  const std::string index = text.substr(0, slash);
  std::optional<int> count;
  if (slash != std::string::npos) {
    count = whole(std::string_view{text}.substr(slash + 1));
    if (!count) refuse(text);
  }
  if (index == "auto") return from_scheduler(count, environment);
  const auto number = whole(index);
  if (!number || !count) refuse(text);
  return {*number, *count};
}

}  // namespace

Shard shard_of(const std::string& text, const Environment& environment) {
  const Shard shard = parsed(text, environment);
  if (shard.count > kMost)
    throw InputError{"--shard: more than " + std::to_string(kMost) + " shards are of no use"};
  if (shard.index >= 1 && shard.index <= shard.count) return shard;
  throw InputError{"--shard: there is no share " + std::to_string(shard.index) + " of " +
                   std::to_string(shard.count) + "; they count from 1"};
}

std::string name_of(const Shard& shard) {
  return std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
}

}  // namespace selion
