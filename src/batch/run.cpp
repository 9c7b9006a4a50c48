// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/batch/run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "folder.hpp"
#include "input.hpp"
#include "merge.hpp"
#include "selion/core/error.hpp"
#include "selion/field/stream.hpp"
#include "selion/output/map.hpp"
#include "work.hpp"

namespace selion {
namespace {

/// The fields of all files in order, numbered; those that are the shard's and have no result yet are handed
/// out.
class Tasks {
 public:
  /// @throws InputError where there is one file, and it cannot be read: that is no batch.
  Tasks(const std::vector<InputFile>& files, const BatchOptions& options, const BatchWatch& watch)
      : files_{files}, options_{options}, watch_{watch} {
    if (files_.size() == 1) open_file();
  }

  /// Before the first task: these have their results.
  void leave_out(std::vector<std::size_t> done) {
    done_ = std::move(done);
    std::ranges::sort(done_);
  }

  /// Null at the end.
  std::shared_ptr<BatchTask> next() {
    while (open_file()) {
      if (trouble_) {
        if (auto task = file_trouble()) return task;
        continue;
      }
      const auto feature = stream_->next();
      if (!feature) {
        close_file();
        continue;
      }
      if (!is_wanted(++number_)) continue;
      return task_of(*feature);
    }
    return nullptr;
  }

  [[nodiscard]] std::size_t numbers() const { return number_; }
  /// Fields that are this shard's, in the files opened so far; and how much of all files that is.
  [[nodiscard]] std::size_t known() const { return known_; }
  [[nodiscard]] double known_share() const {
    return static_cast<double>(opened_) / static_cast<double>(files_.size());
  }

 private:
  /// @returns false where all are read.
  bool open_file() {
    if (stream_ || trouble_) return true;
    if (file_ >= files_.size()) return false;
    ++opened_;
    try {
      stream_.emplace(files_[file_].path, options_.read);
    } catch (const InputError& error) {
      if (files_.size() == 1) throw;
      trouble_ = error.what();
      return true;
    }
    for (std::size_t i = 1, size = stream_->size(); i <= size; ++i) known_ += is_shards(number_ + i) ? 1 : 0;
    for (const std::string& note : stream_->notes()) watch_.note(note);
    return true;
  }

  void close_file() {
    stream_.reset();
    trouble_.reset();
    ++file_;
  }

  std::shared_ptr<BatchTask> file_trouble() {
    auto task = std::make_shared<BatchTask>();
    task->row.number = ++number_;
    task->row.file = task->row.name = files_[file_].name;
    task->row.status = BatchStatus::error;
    task->row.reason = *trouble_;
    close_file();
    if (is_shards(number_)) ++known_;
    return is_wanted(number_) ? task : nullptr;
  }

  std::shared_ptr<BatchTask> task_of(const FieldStream::Feature& feature) {
    auto task = std::make_shared<BatchTask>();
    task->row.number = number_;
    task->row.file = files_[file_].name;
    task->row.layer = feature.layer;
    task->row.feature = feature.number;
    task->row.name = feature.name;
    try {
      task->field = stream_->field();
    } catch (const InputError& error) {
      task->row.status = BatchStatus::error;
      task->row.reason = error.what();
    }
    return task;
  }

  [[nodiscard]] bool is_shards(std::size_t number) const { return options_.shard.has(number); }
  [[nodiscard]] bool is_wanted(std::size_t number) const {
    return is_shards(number) && !std::ranges::binary_search(done_, number);
  }

  const std::vector<InputFile>& files_;
  const BatchOptions& options_;
  const BatchWatch& watch_;
  std::vector<std::size_t> done_;  // by earlier runs
  std::optional<FieldStream> stream_;
  std::optional<std::string> trouble_;
  std::size_t file_ = 0;
  std::size_t number_ = 0;
  std::atomic<std::size_t> opened_ = 0;
  std::atomic<std::size_t> known_ = 0;
};

/// Reads, plans on all threads and writes down, with a few fields for each thread under way.
/// @returns whether it was stopped before the end, and what took long.
std::pair<bool, BatchSlow> work(Tasks& tasks, const BatchOptions& options, ShardJournal& journal,
                                const BatchWatch& watch) {
  struct Timed {
    BatchResult result;
    double took_s = 0;
  };
  using Task = std::shared_ptr<BatchTask>;
  using Result = std::shared_ptr<const Timed>;
  using Clock = std::chrono::steady_clock;
  bool stopped = false;
  BatchSlow slow;
  std::size_t planned = 0;
  const auto read = [&](tbb::flow_control& flow) {
    stopped = stopped || watch.stop();
    Task task = stopped ? nullptr : tasks.next();
    if (!task) flow.stop();
    return task;
  };
  const auto plan_one = [&](const Task& task) -> Result {
    const Clock::time_point started = Clock::now();
    BatchResult result = worked(std::move(*task), options, journal.part_folder());
    const std::chrono::duration<double> took = Clock::now() - started;
    return std::make_shared<const Timed>(Timed{std::move(result), took.count()});
  };
  const auto write_down = [&](const Result& done) {
    journal.add(done->result);
    slow.take(done->result, done->took_s);
    const std::size_t finished = journal.results().size();
    const auto known = static_cast<double>(std::max(tasks.known(), finished));
    watch.progress(
        {finished, ++planned, tasks.known(), tasks.known_share() * static_cast<double>(finished) / known});
  };
  const auto threads = static_cast<std::size_t>(options.threads);
  const tbb::global_control most{tbb::global_control::max_allowed_parallelism, threads};
  tbb::task_arena arena{options.threads};
  arena.execute([&] {
    tbb::parallel_pipeline(
        4 * threads, tbb::make_filter<void, Task>(tbb::filter_mode::serial_in_order, read) &
                         tbb::make_filter<Task, Result>(tbb::filter_mode::parallel, plan_one) &
                         tbb::make_filter<Result, void>(tbb::filter_mode::serial_out_of_order, write_down));
  });
  return {stopped, slow};
}

}  // namespace

void BatchSlow::take(const BatchResult& result, double took_s) {
  fields += took_s > kLong_s ? 1 : 0;
  const auto faster = std::ranges::find_if(slowest, [took_s](const Field& f) { return f.took_s < took_s; });
  slowest.insert(faster, {took_s, result.file + ", field " + std::to_string(result.number)});
  if (slowest.size() > kMostNamed) slowest.pop_back();
}

std::size_t BatchCount::total() const {
  return std::accumulate(by_status.begin(), by_status.end(), std::size_t{0});
}

BatchCount run_batch(const BatchOptions& options, const BatchWatch& watch) {
  const std::vector<InputFile> files = input_files(options.fields, options.folder);
  Tasks tasks{files, options, watch};
  ShardJournal journal{options.folder, identity_of(options, files), options.shard, options.earlier};
  std::vector<std::size_t> done;
  for (const auto& [number, status] : journal.results()) done.push_back(number);
  tasks.leave_out(std::move(done));
  if (options.maps == BatchMaps::drawn) find_fonts();
  BatchCount count;
  if (journal.numbers()) {
    count.numbers = *journal.numbers();
  } else {
    std::tie(count.stopped, count.slow) = work(tasks, options, journal, watch);
    count.numbers = tasks.numbers();
    if (count.stopped)
      journal.flush();
    else
      journal.finish(count.numbers);
  }
  count.by_status = journal.counts();
  if (count.stopped || options.shard.count > 1) return count;
  BatchCount merged =
      write_tables_of(options.folder, {journal_file(options.folder, options.shard)}, journal.part_folder());
  merged.slow = count.slow;
  return merged;
}

}  // namespace selion
