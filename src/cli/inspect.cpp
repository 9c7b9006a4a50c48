// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "commands.hpp"
#include "files.hpp"
#include "options.hpp"
#include "selion/core/error.hpp"
#include "selion/core/input_file.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

struct InspectOptions {
  std::string file;
  std::string units = "metric";
  bool json = false;
  std::shared_ptr<FieldOptions> field;
};

/// A plan file has a foreign member "selion" that is an object; in a field file that word is a property, and
/// a text.
bool is_plan(const std::string& text) {
  constexpr std::string_view kMember = "\"selion\"";
  constexpr std::string_view kSpace = " \t\r\n";
  for (std::size_t at = text.find(kMember); at != std::string::npos; at = text.find(kMember, at + 1)) {
    const std::size_t colon = text.find_first_not_of(kSpace, at + kMember.size());
    if (colon == std::string::npos || text[colon] != ':') continue;
    const std::size_t value = text.find_first_not_of(kSpace, colon + 1);
    if (value != std::string::npos && text[value] == '{') return true;
  }
  return false;
}

/// The text of a file that may be a plan: GeoJSON, or what comes on standard input.
std::optional<std::string> text_to_try(const std::string& file) {
  if (file == "-") return text_of_stream(std::cin, "standard input");
  std::error_code ignored;
  const std::string ending = std::filesystem::path{file}.extension().string();
  const bool may_be =
      (ending == ".geojson" || ending == ".json") && std::filesystem::is_regular_file(file, ignored);
  return may_be ? std::optional{text_of_file(file)} : std::nullopt;
}

Units units_of(const std::string& text) {
  const JobKey& key = job_key("output.units");
  return std::get<std::string>(value_of_text(key, text)) == "imperial" ? Units::imperial : Units::metric;
}

int inspect_plan(const std::string& text, const InspectOptions& options) {
  const PlanFile plan = plan_from_geojson(text, options.file);
  std::cout << (options.json ? json_of(plan, options.file) : text_of(plan, units_of(options.units)));
  return 0;
}

int inspect_fields(std::istream& standard_input, const InspectOptions& options) {
  std::vector<FieldView> views;
  for (const Field& field : read_fields(options.file, read_options_from(*options.field), standard_input))
    views.push_back(view_of(field));
  if (options.json) {
    std::cout << json_of(views, options.file);
  } else {
    std::cout << printable(options.file) << ": " << views.size()
              << (views.size() == 1 ? " field\n" : " fields\n");
    for (const FieldView& view : views) std::cout << text_of(view, units_of(options.units));
  }
  const auto troubled =
      std::ranges::count_if(views, [](const FieldView& view) { return !view.problem.empty(); });
  if (troubled == 0) return 0;
  Terminal{Loudness::normal}.error(options.file + ": " + std::to_string(troubled) + " of " +
                                   std::to_string(views.size()) + " fields cannot be planned as they are");
  return 2;
}

int run_inspect(const InspectOptions& options) {
  if (options.file.empty()) throw InputError{"no file given; name a field file or a plan.geojson"};
  static_cast<void>(units_of(options.units));
  const std::optional<std::string> text = text_to_try(options.file);
  if (text && is_plan(*text)) return inspect_plan(*text, options);
  std::istringstream piped{options.file == "-" ? *text : std::string{}};
  return inspect_fields(piped, options);
}

}  // namespace

Run setup_inspect(CLI::App& app) {
  auto options = std::make_shared<InspectOptions>();
  const OptionGroup own{app, "File and result"};
  own.argument("FILE", options->file, "a field file, a plan.geojson, or - for GeoJSON on standard input");
  own.flag("--json", options->json, "as JSON, for other programs");
  own.text("--units", options->units, "metric|imperial", "of areas and lengths [metric]");
  options->field = add_field_options(app);
  return [options] { return run_inspect(*options); };
}

}  // namespace selion::cli
