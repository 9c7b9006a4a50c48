// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

#include "batch_text.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "output_dir.hpp"
#include "selion/batch/run.hpp"
#include "selion/core/error.hpp"
#include "selion/core/format.hpp"
#include "selion/plan/job_file.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

struct BatchCommand {
  std::string fields, folder, shard, threads, date;
  bool resume = false, overwrite = false, merge = false, maps = false;
  bool repair = false, no_verify = false, print_job = false, json = false, quiet = false;
  std::shared_ptr<JobOptions> job;
  std::shared_ptr<FieldOptions> field;
};

std::optional<std::string> variable(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value == nullptr ? std::nullopt : std::optional<std::string>{value};
}

Earlier earlier_of(const BatchCommand& command) {
  if (command.resume && command.overwrite)
    throw InputError{"--resume goes on with a batch, --overwrite begins it anew; give one of them"};
  if (command.resume) return Earlier::resume;
  return command.overwrite ? Earlier::replace : Earlier::refuse;
}

BatchOptions batch_options(const BatchCommand& command) {
  if (command.field->field)
    throw InputError{"--field: a batch is of all fields; for one there is selion plan --field"};
  return {.fields = command.fields,
          .folder = command.folder,
          .read = read_options_from(*command.field),
          .job = job_from(*command.job),
          .repair = command.repair ? Repair::accept : Repair::notes_only,
          .maps = command.maps ? BatchMaps::drawn : BatchMaps::none,
          .check = command.no_verify ? BatchCheck::none : BatchCheck::verify,
          .date = date_of(command.date),
          .shard = command.shard.empty() ? Shard{} : shard_of(command.shard, variable),
          .earlier = earlier_of(command),
          .threads = threads_of(command.threads)};
}

void check_arguments(const BatchCommand& command) {
  if (command.folder.empty()) throw InputError{"no place for the batch given; say where with -o DIR"};
  if (command.merge && !command.fields.empty())
    throw InputError{"--merge joins what is in -o DIR; leave '" + command.fields + "' out"};
  if (command.merge) return;
  if (command.fields.empty()) throw InputError{"no fields given; name a field file, or a folder of them"};
  if (command.fields == "-")
    throw InputError{"a batch cannot be read from standard input: it could not be resumed; name a file"};
  check_output(command.folder, {}, Existing::replace);
}

/// "42 of 4854 fields, 3 min left"
class Ticker {
 public:
  explicit Ticker(Terminal& terminal) : terminal_{terminal}, started_{std::chrono::steady_clock::now()} {}

  void show(const BatchProgress& progress) {
    if (first_share_ < 0) first_share_ = progress.share - share_of_one(progress);
    const std::string of =
        std::to_string(progress.finished) + " of " + std::to_string(progress.known) + " fields";
    terminal_.progress(of + left(progress), progress.share);
  }

 private:
  static double share_of_one(const BatchProgress& progress) {
    return progress.share / static_cast<double>(std::max<std::size_t>(progress.finished, 1));
  }

  /// By the pace of this run: what earlier ones did took no time of it.
  [[nodiscard]] std::string left(const BatchProgress& progress) const {
    constexpr double kSoonest_s = 2;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
    const double by_this_run = progress.share - first_share_;
    if (spent.count() < kSoonest_s || by_this_run <= 0) return "";
    const double seconds = spent.count() * (1 - progress.share) / by_this_run;
    if (seconds < 90) return ", " + std::to_string(std::lround(seconds)) + " s left";
    const long minutes = std::lround(seconds / 60);
    if (minutes < 90) return ", " + std::to_string(minutes) + " min left";
    return ", " + std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min left";
  }

  Terminal& terminal_;
  std::chrono::steady_clock::time_point started_;
  double first_share_ = -1;
};

/// Ends with 4 where the check found a fault in a plan.
int checked(const BatchCount& count, Terminal& terminal) {
  constexpr int kCheckFailed = 4;
  const std::size_t failed = count.summary.check_failed();
  if (failed == 0) return 0;
  terminal.warning(std::to_string(failed) + (failed == 1 ? " plan does not pass" : " plans do not pass") +
                   " the independent check: column verified says why; do not drive them");
  return kCheckFailed;
}

void say_what_took_long(const BatchSlow& slow, Terminal& terminal) {
  if (slow.fields == 0) return;
  std::string named;
  for (std::size_t i = 0; i < std::min(slow.fields, slow.slowest.size()); ++i)
    named += (i == 0 ? ": " : "; ") + printable(slow.slowest[i].place) + " (" +
             fixed(slow.slowest[i].took_s, 1) + " s)";
  terminal.note(std::to_string(slow.fields) + (slow.fields == 1 ? " field" : " fields") +
                " took longer than " + fixed(BatchSlow::kLong_s, 0) + " s" + named +
                (slow.fields > slow.slowest.size() ? "; and others" : ""));
}

void say_what_is_next(const BatchCount& count, const BatchOptions& options, Terminal& terminal) {
  if (count.stopped)
    return terminal.warning("stopped with " + std::to_string(count.total()) +
                            " fields done; the same command with --resume goes on");
  if (options.shard.count > 1)
    terminal.note("share " + std::to_string(options.shard.index) + " of " +
                  std::to_string(options.shard.count) + " is done; once all are, selion batch --merge -o " +
                  options.folder.string() + " writes the tables");
}

int run_fields(const BatchCommand& command, Terminal& terminal) {
  constexpr int kInterrupted = 130;
  const BatchOptions options = batch_options(command);
  const StopRequest interrupt;
  Ticker ticker{terminal};
  bool told = false;
  const BatchCount count = run_batch(
      options, {.progress = [&](const BatchProgress& progress) { ticker.show(progress); },
                .note = [&](const std::string& note) { terminal.note(note); },
                .stop =
                    [&] {
                      if (StopRequest::made() && !std::exchange(told, true))
                        terminal.note("finishing the fields under way; interrupt again to end at once");
                      return StopRequest::made();
                    }});
  terminal.result(command.json ? json_of(count, command.folder) : text_of(count, command.folder));
  say_what_took_long(count.slow, terminal);
  say_what_is_next(count, options, terminal);
  return count.stopped ? kInterrupted : checked(count, terminal);
}

int run_command(const BatchCommand& command) {
  if (command.print_job) {
    std::cout << job_toml(job_from(*command.job));
    return 0;
  }
  check_arguments(command);
  Terminal terminal{command.quiet ? Loudness::quiet : Loudness::normal};
  if (!command.merge) return run_fields(command, terminal);
  const BatchCount count = merge_batch(command.folder, earlier_of(command));
  terminal.result(command.json ? json_of(count, command.folder) : text_of(count, command.folder));
  return checked(count, terminal);
}

}  // namespace

Run setup_batch(CLI::App& app) {
  auto command = std::make_shared<BatchCommand>();
  const OptionGroup own{app, "Fields and results"};
  own.argument("FIELDS", command->fields, "a file of fields, or a folder of field files");
  own.text("-o,--out", command->folder, "DIR", "the folder for plans, journals and tables");
  own.flag("--resume", command->resume, "go on with what an earlier run has left; begin where there is none");
  own.flag("--overwrite", command->overwrite, "replace an earlier batch");
  own.text("--shard", command->shard, "I/N",
           "only every Nth field, from the Ith; auto: what Slurm and other schedulers say [1/1]");
  own.flag("--merge", command->merge, "write the tables of all shards in DIR; plans nothing");
  own.flag("--maps", command->maps, "a map of each field too, as PDF and SVG");
  own.flag("--json", command->json, "the counts as JSON");
  own.flag("--print-job", command->print_job,
           "print the job with all its defaults as TOML, and plan nothing");
  own.flag("--no-verify", command->no_verify, "leave out the independent check of each plan");
  own.flag("--repair", command->repair, "accept repairs that move a boundary by more than 1 cm");
  own.text("--date", command->date, "DATE", "a date for the maps, YYYY-MM-DD or today [none]");
  own.text("--threads", command->threads, "COUNT", "fields planned at the same time [all processors]");
  own.flag("-q,--quiet", command->quiet, "no notes and no progress; warnings and errors stay");
  command->field = add_field_options(app);
  command->job = add_job_options(app);
  return [command] { return run_command(*command); };
}

}  // namespace selion::cli
