// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/verify/verify.hpp"

#include <filesystem>
#include <iostream>

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "selion/core/error.hpp"
#include "terminal.hpp"
#include "verdict_text.hpp"

namespace selion::cli {
namespace {

struct VerifyOptions {
  std::string plan;
  std::string field;
  std::string layer;
  std::string name;
  std::string obstacles;
  bool json = false;
};

std::optional<GivenField> given_field(const VerifyOptions& options) {
  if (options.field.empty()) {
    if (!options.layer.empty() || !options.name.empty() || !options.obstacles.empty())
      throw InputError{"--layer, --field and --obstacles go with a field file: name it after the plan"};
    return std::nullopt;
  }
  for (const std::string& file : {options.field, options.obstacles})
    if (!file.empty() && !std::filesystem::exists(file)) throw InputError{file + ": there is no such file"};
  GivenField given{.file = options.field};
  if (!options.layer.empty()) given.layer = options.layer;
  if (!options.name.empty()) given.name = options.name;
  if (!options.obstacles.empty()) given.obstacles = options.obstacles;
  return given;
}

int run_verify(const VerifyOptions& options) {
  constexpr int kCheckFailed = 4;
  if (options.plan.empty()) throw InputError{"no plan given; name a plan.geojson"};
  const std::optional<GivenField> given = given_field(options);
  const PlanFile plan = plan_from_geojson(text_of_file(options.plan), options.plan);
  const Verdict verdict = verify(plan, given);
  const WatchList watch = watch_list(plan);
  std::cout << (options.json ? json_of(verdict, worked_twice(plan), watch)
                             : text_of(verdict, watch, options.plan));
  return verdict.findings.empty() ? 0 : kCheckFailed;
}

}  // namespace

Run setup_verify(CLI::App& app) {
  auto options = std::make_shared<VerifyOptions>();
  const std::string group = "Plan and result";
  app.add_option("PLAN", options->plan, "a plan.geojson")->group(group);
  app.add_option("FIELD", options->field, "the field that it was made for, to compare with")->group(group);
  app.add_option("--layer", options->layer, "of the field file")->type_name("NAME")->group(group);
  app.add_option("--field", options->name, "in the field file; else the one where the plan lies")
      ->type_name("NAME|NUMBER")
      ->group(group);
  app.add_option("--obstacles", options->obstacles, "a file of further obstacles, as for plan")
      ->type_name("FILE")
      ->group(group);
  app.add_flag("--json", options->json, "as JSON, for other programs")->group(group);
  return [options] { return run_verify(*options); };
}

}  // namespace selion::cli
