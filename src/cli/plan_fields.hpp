// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output_dir.hpp"
#include "selion/field/block.hpp"
#include "selion/plan/plan.hpp"
#include "terminal.hpp"

namespace selion::cli {

/// The files of a plan, in the order in which they are written.
std::span<const std::string_view> output_names();

struct Task {
  Field field;
  std::filesystem::path folder;
};

enum class Verifying { asked, left_out };

struct PlanSettings {
  Job job;
  Repair repair = Repair::notes_only;
  Existing existing = Existing::refuse;
  std::optional<std::string> date;
  Verifying verifying = Verifying::asked;
};

/// How one field came out.
struct Outcome {
  int status = 0;
  std::string trouble;       ///< why there is no plan, or which check failed
  std::optional<Plan> plan;  ///< without the plan file's lines: what the summary and the report need
  std::string report;        ///< the bytes of report.json
};

/// Plans one field and writes its files. Never throws for what is wrong with one field.
Outcome plan_field(const Task& task, const PlanSettings& settings, const Progress& progress);

/// Plans all of them on `threads` threads; `tell` gets each outcome in the order of the tasks, on this
/// thread's behalf.
/// @returns the worst status, in the order 1, 2, 4, 3, 0.
int plan_fields(const std::vector<Task>& tasks, const PlanSettings& settings, int threads, Terminal& terminal,
                const std::function<void(const Task&, const Outcome&)>& tell);

/// Of two exit statuses the one that several fields end with.
int worse(int a, int b);

/// What a person reads on standard output about one field.
std::string summary_text(const Task& task, const Outcome& outcome, const Job& job);

}  // namespace selion::cli
