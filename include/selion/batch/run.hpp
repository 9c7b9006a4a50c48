// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "selion/batch/result.hpp"
#include "selion/batch/shard.hpp"
#include "selion/batch/summary.hpp"
#include "selion/field/block.hpp"
#include "selion/field/read.hpp"
#include "selion/plan/job.hpp"

namespace selion {

/// What happens to an earlier batch in the same folder.
enum class Earlier { refuse, resume, replace };
enum class BatchMaps { none, drawn };
enum class BatchCheck { verify, none };

struct BatchOptions {
  std::filesystem::path fields;  ///< a file, or a folder whose field files are all read
  std::filesystem::path folder;
  ReadOptions read;
  Job job;
  Repair repair = Repair::notes_only;
  BatchMaps maps = BatchMaps::none;
  BatchCheck check = BatchCheck::verify;  ///< of each plan, by the independent check
  std::optional<std::string> date;        ///< on maps
  Shard shard;
  Earlier earlier = Earlier::refuse;
  int threads = 1;
};

struct BatchProgress {
  std::size_t finished = 0;  ///< fields of this shard with a result, those of earlier runs included
  std::size_t planned = 0;   ///< of these by this run
  std::size_t known = 0;     ///< fields of this shard in the files opened so far
  double share = 0;          ///< of the work, as far as it is known
};

/// Who looks on. Each is called by one thread at a time, not always the same one.
struct BatchWatch {
  std::function<void(const BatchProgress&)> progress;
  std::function<void(const std::string&)> note;  ///< what there is to say of a file
  std::function<bool()> stop;                    ///< whether to finish the fields under way and begin no more
};

/// Fields of this run that took long, on the clock.
struct BatchSlow {
  static constexpr double kLong_s = 2;
  static constexpr std::size_t kMostNamed = 10;
  struct Field {
    double took_s = 0;
    std::string place;  ///< its file and number
  };
  std::size_t fields = 0;      ///< that took longer
  std::vector<Field> slowest;  ///< at most so many, the slowest first, those that took less among them

  void take(const BatchResult& result, double took_s);
};

struct BatchCount {
  std::array<std::size_t, kBatchStatusNames.size()> by_status{};  ///< of this shard, or of all when merged
  std::size_t numbers = 0;                                        ///< in the whole batch
  bool stopped = false;                                           ///< before all had a result
  bool tables = false;                                            ///< whether they were written
  BatchSummary summary;                                           ///< of the tables
  BatchSlow slow;

  [[nodiscard]] std::size_t total() const;
};

/// Plans every field of `options.fields` that is the shard's, and writes plan files, the shard's journal and,
/// of a batch of one shard, the tables. The same files for any number of threads, and however often it was
/// stopped or killed and resumed. What is wrong with a field or a file is its result.
/// @throws InputError where the files of the batch cannot be written, or an earlier batch is in the way.
BatchCount run_batch(const BatchOptions& options, const BatchWatch& watch);

/// The tables of all shards of a batch, in the order of the fields; `tables`: what happens to those that are
/// there.
/// @throws InputError naming the shards that are missing or not finished, or do not belong together.
BatchCount merge_batch(const std::filesystem::path& folder, Earlier tables);

/// The tables' names in the batch's folder.
constexpr auto kBatchTables = std::to_array<std::string_view>({"results.csv", "results.gpkg"});

}  // namespace selion
