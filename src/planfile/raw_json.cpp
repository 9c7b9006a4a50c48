// SPDX-License-Identifier: GPL-3.0-or-later
#include "raw_json.hpp"

#include <algorithm>

namespace selion {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

std::size_t after_space(std::string_view json, std::size_t at) {
  return std::min(json.find_first_not_of(kSpace, at), json.size());
}

/// `at` is on the opening quote.
std::size_t after_string(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at) {
    if (json[at] == '\\') ++at;
  }
  return std::min(at + 1, json.size());
}

/// Brackets and braces: 1, or -1 for closed ones.
int opened(char c) {
  if (c < '[') return 0;  // nearly all of a plan
  if (c == '{' || c == '[') return 1;
  return c == '}' || c == ']' ? -1 : 0;
}

/// `at` is on the opening bracket or brace.
std::size_t after_brackets(std::string_view json, std::size_t at) {
  int depth = 0;
  do {
    depth += opened(json[at]);
    at = json[at] == '"' ? after_string(json, at) : at + 1;
  } while (depth > 0 && at < json.size());
  return at;
}

std::size_t after_value(std::string_view json, std::size_t at) {
  if (at >= json.size()) return json.size();
  if (json[at] == '"') return after_string(json, at);
  if (json[at] == '{' || json[at] == '[') return after_brackets(json, at);
  return std::min(json.find_first_of(",]} \t\r\n", at), json.size());
}

}  // namespace

std::string_view raw_member(std::string_view json, std::string_view key) {
  std::string_view found;
  std::size_t at = json.find('{');
  while (at < json.size() && json[at] != '}') {
    const std::size_t name = after_space(json, at + 1);  // behind the brace or the comma
    if (name == json.size() || json[name] != '"') break;
    const std::size_t name_end = after_string(json, name);
    const std::size_t value = after_space(json, json.find(':', name_end) + 1);
    const std::size_t value_end = after_value(json, value);
    if (json.substr(name + 1, name_end - name - 2) == key) found = json.substr(value, value_end - value);
    at = after_space(json, value_end);
  }
  return found;
}

std::string compacted(std::string_view json) {
  std::string out;
  std::size_t at = 0;
  while ((at = after_space(json, at)) < json.size()) {
    const std::size_t end = json[at] == '"' ? after_string(json, at) : at + 1;
    out += json.substr(at, end - at);
    at = end;
  }
  return out;
}

}  // namespace selion
