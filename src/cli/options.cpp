// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <string_view>
#include <thread>
#include <utility>

#include <CLI/CLI.hpp>

#include "files.hpp"
#include "selion/core/error.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/suggest.hpp"
#include "selion/plan/text.hpp"

namespace selion::cli {
namespace {

constexpr const char* kReading = "Reading fields";

std::string title(std::string_view table) {
  constexpr auto kTitles = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"", "Job"},
      {"machine", "Machine (in brackets the values of robot-3m)"},
      {"field", "Distances kept"},
      {"frame", "Frame"},
      {"layout", "Layout"},
      {"headland", "Headland"},
      {"route", "Route"},
      {"output", "Map and report"},
  });
  for (const auto& [name, words] : kTitles)
    if (name == table) return std::string{words};
  return std::string{table};
}

/// What stands behind the flag in the help: "NUMBER", "true|false".
std::string kind_of_value(const JobKey& key) {
  if (key.name == "preset") return "NAME|FILE.toml";
  switch (key.type) {
    case JobType::number:
      return "NUMBER";
    case JobType::count:
      return "COUNT";
    case JobType::truth:
      return "true|false";
    case JobType::heading:
      return std::string{key.choices} + "|HEADING";
    case JobType::line:
      return "LON1,LAT1,LON2,LAT2";
    case JobType::text:
      break;
  }
  return key.choices.empty() ? "TEXT" : key.choices.size() > 24 ? "NAME" : std::string{key.choices};
}

std::string default_of(const JobKey& key) {
  const JobValue usual = key.get(Job{});
  if (std::holds_alternative<Absent>(usual)) return std::string{key.absent};
  const bool as_it_is = key.type != JobType::text || std::get<std::string>(usual).empty();
  std::string text = as_it_is ? text_of_value(key, usual) : std::get<std::string>(usual);
  if (text == "\"\"") return "none";
  std::erase(text, '"');
  return key.unit.empty() || key.type == JobType::heading ? text : text + " " + std::string{key.unit};
}

std::string described(const JobKey& key) {
  const bool listed = kind_of_value(key) == "NAME" || key.name == "preset";
  const auto choices = split_at_bars(key.choices);
  return std::string{key.help} + (listed ? ": " + spoken_list(choices) : "") + " [" + default_of(key) + "]";
}

/// How an option stands in the help.
struct Words {
  const char* names;
  const char* type;
  const char* about;
};

void add_text(CLI::App& app, const char* group, const Words& words, std::optional<std::string>& into) {
  auto* option = app.add_option_function<std::string>(
      words.names, [&into](const std::string& text) { into = text; }, words.about);
  option->type_name(words.type)->group(group)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

bool names_a_file(const std::string& machine) {
  return machine.ends_with(".toml") || machine.find('/') != std::string::npos;
}

void add_flag_setting(JobSettings& settings, const JobKey& key, const std::string& text) {
  try {
    settings.push_back({&key, value_of_text(key, text), std::string{key.flag}});
  } catch (const InputError& error) {
    const bool is_machine = key.name == "preset";
    throw InputError{std::string{key.flag} + ": " + error.what() +
                     (is_machine ? "; for a machine of your own give its file: NAME.toml" : "")};
  }
}

/// `--machine` puts another machine in the place of the job file's.
void take_machine(JobSettings& settings, const std::string& machine) {
  std::erase_if(settings, [](const JobSetting& s) { return s.key->table == "machine"; });
  if (!names_a_file(machine)) return add_flag_setting(settings, job_key("machine.preset"), machine);
  const JobSettings own = settings_of_machine_toml(text_of_file(machine), machine);
  settings.insert(settings.end(), own.begin(), own.end());
}

std::string today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm local{};
  localtime_r(&now, &local);
  std::string text = "0000-00-00";
  text.resize(std::strftime(text.data(), text.size() + 1, "%Y-%m-%d", &local));
  return text;
}

}  // namespace

void OptionGroup::text(const char* names, std::string& into, const char* type, const char* about) const {
  app_.add_option(names, into, about)->type_name(type)->group(heading_);
}

void OptionGroup::flag(const char* names, bool& into, const char* about) const {
  app_.add_flag(names, into, about)->group(heading_);
}

void OptionGroup::argument(const char* name, std::string& into, const char* about) const {
  app_.add_option(name, into, about)->group(heading_);
}

void OptionGroup::arguments(const char* name, std::vector<std::string>& into, const char* about) const {
  app_.add_option(name, into, about)->group(heading_);
}

std::shared_ptr<JobOptions> add_job_options(CLI::App& app) {
  auto options = std::make_shared<JobOptions>();
  add_text(app, "Job", {"--job", "FILE.toml", "a job file; flags win over it"}, options->file);
  for (const JobKey& key : job_keys()) {
    const std::string names = std::string{key.flag} + (key.alias.empty() ? "" : "," + std::string{key.alias});
    const std::string full = full_name(key);
    auto* option = app.add_option_function<std::string>(
        names, [options = options.get(), full](const std::string& text) { options->flags[full] = text; },
        described(key));
    option->type_name(kind_of_value(key))->group(title(key.table));
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }
  return options;
}

Job job_from(const JobOptions& options) {
  JobSettings settings;
  if (options.file) settings = settings_of_toml(text_of_file(*options.file), *options.file);
  const auto machine = options.flags.find("machine.preset");
  if (machine != options.flags.end()) take_machine(settings, machine->second);
  for (const JobKey& key : job_keys()) {
    const auto flag = options.flags.find(full_name(key));
    if (flag != options.flags.end() && flag != machine) add_flag_setting(settings, key, flag->second);
  }
  return job_of(settings);
}

std::shared_ptr<FieldOptions> add_boundary_options(CLI::App& app) {
  auto options = std::make_shared<FieldOptions>();
  const auto add = [&app](std::optional<std::string>& into, const Words& words) {
    add_text(app, kReading, words, into);
  };
  add(options->field, {"--field", "NAME|NUMBER", "only this field of a file"});
  add(options->layer, {"--layer", "NAME", "only this layer of a file"});
  add(options->crs, {"--crs", "EPSG:CODE", "coordinate system of a file that does not say"});
  add(options->axis, {"--axis", "lonlat|latlon", "order of the numbers in a CSV or text file [lonlat]"});
  add(options->obstacles, {"--obstacles", "FILE", "a file of obstacles"});
  add(options->gates, {"--gates", "FILE", "a file of gates"});
  return options;
}

std::shared_ptr<FieldOptions> add_field_options(CLI::App& app) {
  auto options = add_boundary_options(app);
  add_text(app, kReading,
           {"--accept-datum-error", "NUMBER",
            "take coordinates whose datum is known no better than this, in m [5]"},
           options->accept_datum_error_m);
  return options;
}

ReadOptions read_options_from(const FieldOptions& options) {
  ReadOptions read{.layer = options.layer,
                   .crs = options.crs,
                   .axis = AxisOrder::lonlat,
                   .field = options.field,
                   .obstacles = options.obstacles,
                   .gates = options.gates,
                   .accept_datum_error_m = std::nullopt};
  constexpr auto kOrders = std::to_array<std::string_view>({"lonlat", "latlon"});
  if (options.axis == "latlon")
    read.axis = AxisOrder::latlon;
  else if (options.axis && *options.axis != "lonlat")
    throw InputError{"--axis: '" + *options.axis + "' is not known; there is lonlat or latlon" +
                     did_you_mean(*options.axis, kOrders)};
  if (!options.accept_datum_error_m) return read;
  read.accept_datum_error_m = number_of_text(*options.accept_datum_error_m);
  if (!read.accept_datum_error_m || *read.accept_datum_error_m < 0)
    throw InputError{"--accept-datum-error: '" + *options.accept_datum_error_m +
                     "' is not a distance in metres"};
  return read;
}

int threads_of(const std::string& text) {
  if (text.empty()) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const auto number = number_of_text(text);
  if (!number || *number < 1 || *number > 1024 || *number != static_cast<int>(*number))
    throw InputError{"--threads: '" + text + "' is not a whole number from 1 to 1024"};
  return static_cast<int>(*number);
}

std::optional<std::string> date_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (text == "today") return today();
  const bool shaped = text.size() == 10 && text[4] == '-' && text[7] == '-';
  const auto part = [&](std::size_t from, std::size_t size) {
    return static_cast<int>(number_of_text(text.substr(from, size)).value_or(-1));
  };
  const bool digits = std::ranges::all_of(text, [](char c) { return c == '-' || (c >= '0' && c <= '9'); });
  using namespace std::chrono;
  if (shaped && digits &&
      year_month_day{year{part(0, 4)}, month{static_cast<unsigned>(part(5, 2))},
                     day{static_cast<unsigned>(part(8, 2))}}
          .ok())
    return text;
  throw InputError{"--date: '" + text + "' is no date; write 2026-05-31, or today"};
}

}  // namespace selion::cli
