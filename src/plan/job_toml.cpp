// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "selion/core/error.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/suggest.hpp"

namespace selion {
namespace {

std::string place(const std::string& where, const toml::source_region& source) {
  return where + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
}

/// toml++ follows the parts of a key one inside the other, however many there are.
void refuse_endless_keys(std::string_view text, const std::string& where) {
  constexpr int kMostParts = 100;
  constexpr std::string_view kEnds = "\n=,[]{}";
  int parts = 1;
  int line = 1;
  char before = '\n';
  for (const char c : text) {
    if (c == '\n') ++line;
    if (kEnds.find(c) != std::string_view::npos || (c == '.' && before == '.')) parts = 1;  // "..": in words
    before = c;
    if (c == '.' && ++parts > kMostParts)
      throw InputError{where + ":" + std::to_string(line) + ": a key of more than " +
                       std::to_string(kMostParts) + " parts"};
  }
}

toml::table parsed(std::string_view text, const std::string& where) {
  refuse_endless_keys(text, where);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw InputError{place(where, error.source()) + ": " + std::string{error.description()}};
  }
}

/// toml++ gives no double for whole numbers that a double cannot hold exactly: the nearest one will do, to be
/// out of range.
double number_of(const toml::node& node) {
  const toml::value<std::int64_t>* whole = node.as_integer();
  return whole != nullptr ? static_cast<double>(whole->get()) : *node.value<double>();
}

JobValue list_value(const toml::array& array, const std::string& at) {
  std::vector<double> numbers;
  for (const toml::node& element : array) {
    if (!element.is_number()) throw InputError{at + ": the list may hold numbers only"};
    numbers.push_back(number_of(element));
  }
  return numbers;
}

JobValue value_of(const toml::node& node, const std::string& at) {
  if (node.is_number()) return number_of(node);
  if (node.is_boolean()) return *node.value<bool>();
  if (node.is_string()) return *node.value<std::string>();
  if (const toml::array* array = node.as_array()) return list_value(*array, at);
  throw InputError{at + ": neither a number, a text in quotes, true, false nor a list of numbers"};
}

const JobKey* find(std::string_view table, std::string_view name) {
  for (const JobKey& key : job_keys())
    if (key.table == table && key.name == name) return &key;
  return nullptr;
}

std::vector<std::string_view> tables() {
  std::vector<std::string_view> names;
  for (const JobKey& key : job_keys())
    if (!key.table.empty() && (names.empty() || names.back() != key.table)) names.push_back(key.table);
  return names;
}

/// Where the key would have been right, or the nearest one that would.
std::string advice(std::string_view table, std::string_view name) {
  std::vector<std::string_view> here = table.empty() ? tables() : std::vector<std::string_view>{};
  for (const JobKey& key : job_keys()) {
    if (key.name == name)
      return "; it belongs " +
             (key.table.empty() ? "at the top of the file" : "in [" + std::string{key.table} + "]");
    if (key.table == table) here.push_back(key.name);
  }
  return did_you_mean(name, here);
}

[[noreturn]] void refuse_key(std::string_view table, std::string_view name, const std::string& at) {
  if (table.empty() && name == "fleet")
    throw InputError{at + ": [[fleet]] is not supported yet; there is one [machine]"};
  const std::string in = table.empty() ? "" : " in [" + std::string{table} + "]";
  throw InputError{at + ": unknown key '" + std::string{name} + "'" + in + advice(table, name)};
}

JobSetting setting(const JobKey& key, const toml::node& node, const std::string& at) {
  try {
    return {&key, fitted(key, value_of(node, at)), at};
  } catch (const InputError& error) {
    const std::string message = error.what();
    throw InputError{message.starts_with(at) ? message : at + ": " + message};
  }
}

void read_table(const toml::table& from, std::string_view table, const std::string& where,
                JobSettings& into) {
  for (const auto& [name, node] : from) {
    const std::string at = place(where, name.source());
    const JobKey* key = find(table, name.str());
    if (key == nullptr) refuse_key(table, name.str(), at);
    into.push_back(setting(*key, node, at));
  }
}

bool is_table(std::string_view name) { return std::ranges::count(tables(), name) > 0; }

}  // namespace

JobSettings settings_of_toml(std::string_view text, const std::string& where) {
  JobSettings settings;
  toml::table root = parsed(text, where);
  toml::table bare;
  for (const auto& [name, node] : root) {
    const std::string at = place(where, name.source());
    if (!is_table(name.str())) {
      bare.insert(name, node);
      continue;
    }
    const toml::table* table = node.as_table();
    if (table == nullptr)
      throw InputError{at + ": '" + std::string{name.str()} + "' is a table: write [" +
                       std::string{name.str()} + "] and its keys below"};
    read_table(*table, name.str(), where, settings);
  }
  read_table(bare, "", where, settings);
  return settings;
}

JobSettings settings_of_machine_toml(std::string_view text, const std::string& where) {
  const toml::table root = parsed(text, where);
  JobSettings settings;
  const toml::table* machine = root["machine"].as_table();
  if (machine != nullptr && root.size() > 1)
    throw InputError{where + ": a machine file holds [machine] alone; give a whole job with --job"};
  read_table(machine != nullptr ? *machine : root, "machine", where, settings);
  const JobKey& preset = job_key("machine.preset");
  const bool named = std::ranges::any_of(settings, [&](const JobSetting& s) { return s.key == &preset; });
  if (!named)
    settings.insert(settings.begin(), {&preset, std::string{machine_presets().front().name}, where});
  return settings;
}

}  // namespace selion
