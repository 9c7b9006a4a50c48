// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <set>
#include <utility>

#include "commands.hpp"
#include "options.hpp"
#include "plan_fields.hpp"
#include "selion/core/error.hpp"
#include "selion/core/json_writer.hpp"
#include "selion/output/file_name.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/text.hpp"

namespace selion::cli {
namespace {

struct PlanOptions {
  std::vector<std::string> files;
  std::string folder;
  std::string threads;
  std::string date;
  bool print_job = false, overwrite = false, repair = false, no_verify = false, json = false, quiet = false;
  std::shared_ptr<JobOptions> job;
  std::shared_ptr<FieldOptions> field;
};

/// The fields of one argument, or why there are none.
struct Reading {
  std::string file;
  std::vector<Field> fields;
  std::string trouble;
};

std::vector<Reading> read_all(const PlanOptions& options) {
  const ReadOptions how = read_options_from(*options.field);
  std::vector<Reading> readings;
  for (const std::string& file : options.files) {
    try {
      readings.push_back({file, read_fields(file, how, std::cin), ""});
    } catch (const InputError& error) {
      if (options.files.size() == 1) throw;
      readings.push_back({file, {}, error.what()});
    }
  }
  return readings;
}

/// One field goes into DIR itself, each of several into a folder of its own.
std::vector<Task> tasks_of(std::vector<Reading> readings, const std::string& folder) {
  std::vector<Task> tasks;
  for (Reading& reading : readings)
    for (Field& field : reading.fields) tasks.push_back({std::move(field), folder});
  if (tasks.size() == 1 && readings.size() == 1) return tasks;
  std::set<int> numbers;
  for (const Task& task : tasks) numbers.insert(task.field.number);
  const bool unique = numbers.size() == tasks.size();  // those of two files or layers may meet
  int running = 0;
  for (Task& task : tasks)
    task.folder /= folder_name(unique ? task.field.number : ++running, task.field.name);
  return tasks;
}

/// Says on standard error what belongs to one field.
/// `assumed`: what was told already, for it is the same of most fields of a file.
void tell_field(Terminal& terminal, const Task& task, const Outcome& outcome,
                std::set<std::string>& assumed) {
  const std::string before = task.field.name + ": ";
  if (!outcome.plan) return terminal.error(before + outcome.trouble);
  const Plan& plan = *outcome.plan;
  for (const std::string& note : task.field.notes)
    if (std::ranges::count(plan.notes, note) + std::ranges::count(plan.file.warnings, note) == 0)
      terminal.note(before + note);
  for (const std::string& note : plan.notes) terminal.note(before + note);
  for (const std::string& assumption : plan.assumptions)
    if (assumed.insert(assumption).second) terminal.note(assumption);
  for (const std::string& warning : plan.file.warnings) terminal.warning(before + warning);
  if (!outcome.trouble.empty()) terminal.error(before + outcome.trouble);
}

std::string json_entry(const Task& task, const Outcome& outcome) {
  JsonWriter json;
  json.begin_object(JsonSpread::line)
      .key("number")
      .whole(task.field.number)
      .key("name")
      .text(task.field.name);
  json.key("folder").text(task.folder.string()).key("status").whole(outcome.status);
  json.key("trouble").text(outcome.trouble).key("report");
  const std::size_t end = outcome.report.find_last_not_of('\n');
  return json.raw(end == std::string::npos ? "null" : outcome.report.substr(0, end + 1)).end().str();
}

/// Standard output: a summary a field, or its report; of several fields a list of them.
class Results {
 public:
  Results(const PlanOptions& options, const Job& job, bool several)
      : json_{options.json}, list_{options.json && several}, job_{job} {}

  [[nodiscard]] std::string start() const { return list_ ? "[\n" : ""; }
  [[nodiscard]] std::string next(const Task& task, const Outcome& outcome) {
    const bool first = std::exchange(first_, false);
    if (!json_) return summary_text(task, outcome, job_);
    return list_ ? (first ? "" : ",\n") + json_entry(task, outcome) : outcome.report;
  }
  [[nodiscard]] std::string end() const { return list_ ? "\n]\n" : ""; }

 private:
  bool json_;
  bool list_;
  bool first_ = true;
  const Job& job_;
};

PlanSettings settings_of(const PlanOptions& options) {
  return {.job = job_from(*options.job),
          .repair = options.repair ? Repair::accept : Repair::notes_only,
          .existing = options.overwrite ? Existing::replace : Existing::refuse,
          .date = date_of(options.date),
          .verifying = options.no_verify ? Verifying::left_out : Verifying::asked};
}

void check_arguments(const PlanOptions& options) {
  if (options.files.empty())
    throw InputError{"no field given; name a field file, or - for GeoJSON on standard input"};
  if (options.folder.empty()) throw InputError{"no place for the plan given; say where with -o DIR"};
  if (std::ranges::count(options.files, "-") > 1)
    throw InputError{"standard input (-) can be read only once"};
}

int run_plan(const PlanOptions& options) {
  const PlanSettings settings = settings_of(options);
  if (options.print_job) {
    std::cout << job_toml(settings.job);
    return 0;
  }
  check_arguments(options);
  const int threads = threads_of(options.threads);
  std::vector<Reading> readings = read_all(options);
  Terminal terminal{options.quiet ? Loudness::quiet : Loudness::normal};
  int status = 0;
  for (const Reading& reading : readings) {
    if (reading.trouble.empty()) continue;
    terminal.error(reading.trouble);
    status = 2;
  }
  const bool several = readings.size() > 1 || readings.front().fields.size() > 1;
  const std::vector<Task> tasks = tasks_of(std::move(readings), options.folder);
  for (const Task& task : tasks) check_output(task.folder, output_names(), settings.existing);

  Results results{options, settings.job, several};
  terminal.result(results.start());
  std::set<std::string> assumed;
  const auto tell = [&](const Task& task, const Outcome& outcome) {
    tell_field(terminal, task, outcome, assumed);
    terminal.result(results.next(task, outcome));
  };
  const int planned = plan_fields(tasks, settings, threads, terminal, tell);
  terminal.result(results.end());
  return worse(status, planned);
}

}  // namespace

Run setup_plan(CLI::App& app) {
  auto options = std::make_shared<PlanOptions>();
  const OptionGroup own{app, "Fields and results"};
  own.arguments("FIELD", options->files,
                "any vector file with polygons, CSV of coordinates, or - for GeoJSON on standard input");
  own.text("-o,--out", options->folder, "DIR",
           "the folder for map, paths and report; of several fields one folder each below it");
  own.flag("--overwrite", options->overwrite, "replace the files of an earlier plan");
  own.flag("--json", options->json, "the report on standard output instead of the summary");
  own.flag("--print-job", options->print_job,
           "print the job with all its defaults as TOML, and plan nothing");
  own.flag("--no-verify", options->no_verify, "leave out the independent check of the plan");
  own.flag("--repair", options->repair, "accept repairs that move a boundary by more than 1 cm");
  own.text("--date", options->date, "DATE", "a date for the map, YYYY-MM-DD or today [none]");
  own.text("--threads", options->threads, "COUNT", "fields planned at the same time [all processors]");
  own.flag("-q,--quiet", options->quiet, "no notes and no progress; warnings and errors stay");
  options->field = add_field_options(app);
  options->job = add_job_options(app);
  return [options] { return run_plan(*options); };
}

}  // namespace selion::cli
