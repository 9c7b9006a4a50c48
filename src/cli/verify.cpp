// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/verify/verify.hpp"

#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "files.hpp"
#include "options.hpp"
#include "selion/core/error.hpp"
#include "selion/core/input_file.hpp"
#include "terminal.hpp"
#include "verdict_text.hpp"

namespace selion::cli {
namespace {

struct VerifyOptions {
  std::string plan;
  std::string field;
  std::shared_ptr<FieldOptions> reading;
  bool json = false;
};

std::optional<GivenField> given_field(const VerifyOptions& options) {
  const ReadOptions read = read_options_from(*options.reading);
  if (options.field.empty()) {
    const FieldOptions& r = *options.reading;
    if (r.field || r.layer || r.crs || r.axis || r.obstacles || r.gates)
      throw InputError{"options for reading fields go with a field file: name it after the plan"};
    return std::nullopt;
  }
  for (const std::filesystem::path& file :
       {std::filesystem::path{options.field}, read.obstacles.value_or(""), read.gates.value_or("")}) {
    if (file.empty()) continue;
    if (!std::filesystem::exists(file)) throw InputError{file.string() + ": there is no such file"};
    refuse_endless(file);
  }
  return GivenField{.file = options.field,
                    .layer = read.layer,
                    .name = read.field,
                    .crs = read.crs,
                    .order = read.axis == AxisOrder::latlon ? TextOrder::latlon : TextOrder::lonlat,
                    .obstacles = read.obstacles,
                    .gates = read.gates};
}

int run_verify(const VerifyOptions& options) {
  constexpr int kCheckFailed = 4;
  if (options.plan.empty()) throw InputError{"no plan given; name a plan.geojson"};
  const std::optional<GivenField> given = given_field(options);
  const bool piped = options.plan == "-";
  const std::string where = piped ? "standard input" : options.plan;
  const std::string text = piped ? text_of_stream(std::cin, where) : text_of_file(options.plan);
  if (text.empty()) throw InputError{where + " is empty; give a plan.geojson"};
  const PlanFile plan = plan_from_geojson(text, where);
  const Verdict verdict = verify(plan, given);
  const WatchList watch = watch_list(plan);
  std::cout << (options.json ? json_of(verdict, worked_twice(plan), watch) : text_of(verdict, watch, where));
  return verdict.findings.empty() ? 0 : kCheckFailed;
}

}  // namespace

Run setup_verify(CLI::App& app) {
  auto options = std::make_shared<VerifyOptions>();
  const OptionGroup own{app, "Plan and result"};
  own.argument("PLAN", options->plan, "a plan.geojson, or - for one on standard input");
  own.argument("FIELD", options->field, "the field that it was made for, to compare with");
  own.flag("--json", options->json, "as JSON, for other programs");
  options->reading = add_boundary_options(app);
  return [options] { return run_verify(*options); };
}

}  // namespace selion::cli
