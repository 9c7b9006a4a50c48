// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan_fields.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "selion/batch/verified.hpp"
#include "selion/core/error.hpp"
#include "selion/output/map.hpp"
#include "selion/output/report.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion::cli {
namespace {

constexpr auto kNames =
    std::to_array<std::string_view>({"plan.geojson", "map.svg", "map.pdf", "report.json"});

/// The plan file's bytes, and what is wrong with them.
struct PlanBytes {
  OutputFile file;
  std::string fault;  ///< empty where it reads back and no check failed
  std::optional<Verification> verification;
};

/// "2 faults found: body_outside: the body gets ..."
std::string fault_text(const Verification& said) {
  if (said.faults.empty()) return "";
  const std::string more =
      said.faults.size() == 1 ? "a fault" : std::to_string(said.faults.size()) + " faults";
  return "the independent check of the plan found " + more + ": " + said.faults.front();
}

/// A plan that cannot be read back is of no use to whoever is to drive it.
PlanBytes plan_bytes_of(const Plan& plan, Verifying verifying) {
  PlanBytes out{{std::string{kNames[0]}, to_geojson(plan.file)}, "", std::nullopt};
  try {
    const PlanFile read = plan_from_geojson(out.file.bytes, out.file.name);
    if (verifying == Verifying::left_out) return out;
    out.verification = verification_of(read);
    out.fault = fault_text(*out.verification);
  } catch (const InputError& error) {
    out.fault = std::string{"the plan that was written does not read back: "} + error.what();
  }
  return out;
}

MapFiles map_of(const Plan& plan, const PlanSettings& settings) {
  MapText text = map_text(plan, settings.job);
  text.date = settings.date;
  return map_files(plan.file, text, map_options(settings.job));
}

struct Files {
  std::vector<OutputFile> files;
  std::string fault;
};

/// The check of the plan file takes about as long as the map: the map is drawn meanwhile, for a plan that
/// passes, and again where it does not.
Files files_of(Plan& plan, const PlanSettings& settings) {
  if (settings.verifying == Verifying::asked) plan.verification = Verification{};
  const Plan& drawn = plan;
  std::future<PlanBytes> checking =
      std::async([&drawn, &settings] { return plan_bytes_of(drawn, settings.verifying); });
  MapFiles map = map_of(plan, settings);
  PlanBytes checked = checking.get();
  if (checked.verification != plan.verification) {
    plan.verification = std::move(checked.verification);
    map = map_of(plan, settings);
  }
  return {{std::move(checked.file),
           {std::string{kNames[1]}, std::move(map.svg)},
           {std::string{kNames[2]}, std::move(map.pdf)},
           {std::string{kNames[3]}, report_json(plan)}},
          std::move(checked.fault)};
}

/// Lines of many thousand places are not needed once they are written.
void drop_lines(PlanFile& file) {
  file.trajectories.clear();
  file.swaths.clear();
  file.headland_passes.clear();
}

Outcome planned(const Task& task, const PlanSettings& settings, const Progress& progress) {
  Result<Plan> plan = selion::plan(task.field, settings.job, settings.repair, progress);
  if (!plan) return {.status = 3, .trouble = plan.error().reason, .plan = std::nullopt, .report = {}};
  auto [files, fault] = files_of(*plan, settings);
  write_output(task.folder, files, settings.existing);
  Outcome outcome{
      .status = 0, .trouble = std::move(fault), .plan = std::nullopt, .report = std::move(files[3].bytes)};
  if (!outcome.trouble.empty()) outcome.status = 4;
  drop_lines(plan->file);
  outcome.plan = *std::move(plan);
  return outcome;
}

/// The outcomes that are there, handed on in the order of the tasks.
class InOrder {
 public:
  InOrder(const std::vector<Task>& tasks, const std::function<void(const Task&, const Outcome&)>& tell)
      : tasks_{tasks}, tell_{tell}, outcomes_(tasks.size()) {}

  void add(std::size_t index, Outcome outcome) {
    const std::scoped_lock lock{mutex_};
    outcomes_[index] = std::move(outcome);
    for (; next_ < tasks_.size() && outcomes_[next_]; ++next_) {
      status_ = worse(status_, outcomes_[next_]->status);
      tell_(tasks_[next_], *outcomes_[next_]);
      outcomes_[next_].reset();
    }
  }
  [[nodiscard]] int status() const { return status_; }

 private:
  const std::vector<Task>& tasks_;
  const std::function<void(const Task&, const Outcome&)>& tell_;
  std::vector<std::optional<Outcome>> outcomes_;
  std::size_t next_ = 0;
  int status_ = 0;
  std::mutex mutex_;
};

/// What the terminal shows of one field's progress among `count`.
Progress progress_of(Terminal& terminal, const Task& task, const std::atomic<std::size_t>& finished,
                     std::size_t count) {
  return [&terminal, &task, &finished, count](std::string_view stage, double share) {
    if (count == 1) return terminal.progress(task.field.name + ": " + std::string{stage}, share);
    const std::size_t done = finished.load();
    terminal.progress(std::to_string(done) + " of " + std::to_string(count) + " fields",
                      static_cast<double>(done) / static_cast<double>(count));
  };
}

}  // namespace

std::span<const std::string_view> output_names() { return kNames; }

int worse(int a, int b) {
  constexpr auto kOrder = std::to_array<int>({1, 2, 4, 3, 0});
  return std::min(std::ranges::find(kOrder, a), std::ranges::find(kOrder, b)) == std::ranges::find(kOrder, a)
             ? a
             : b;
}

Outcome plan_field(const Task& task, const PlanSettings& settings, const Progress& progress) {
  try {
    return planned(task, settings, progress);
  } catch (const InputError& error) {
    return {.status = 2, .trouble = error.what(), .plan = std::nullopt, .report = {}};
  } catch (const std::exception& error) {
    return {.status = 1,
            .trouble = std::string{"selion failed, and should not have: "} + error.what() +
                       "; please report it with the command and the file",
            .plan = std::nullopt,
            .report = {}};
  }
}

int plan_fields(const std::vector<Task>& tasks, const PlanSettings& settings, int threads, Terminal& terminal,
                const std::function<void(const Task&, const Outcome&)>& tell) {
  const std::future<void> fonts = std::async(find_fonts);
  InOrder outcomes{tasks, tell};
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> finished = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      outcomes.add(i,
                   plan_field(tasks[i], settings, progress_of(terminal, tasks[i], finished, tasks.size())));
      ++finished;
    }
  };
  std::vector<std::jthread> others;
  const std::size_t wanted = std::min(static_cast<std::size_t>(threads), tasks.size());
  for (std::size_t i = 1; i < wanted; ++i) others.emplace_back(work);
  work();
  others.clear();
  return outcomes.status();
}

}  // namespace selion::cli
