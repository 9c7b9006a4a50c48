// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "selion/core/error.hpp"
#include "selion/plan/job_keys.hpp"
#include "selion/plan/suggest.hpp"
#include "selion/plan/text.hpp"

namespace selion {
namespace {

/// "4", "'edge'" or what else a person wrote.
std::string as_written(const JobValue& value) {
  if (const double* number = std::get_if<double>(&value))
    return std::isfinite(*number) ? number_text(*number) : "a number that is not finite";
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const std::string* text = std::get_if<std::string>(&value)) return "'" + *text + "'";
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    return "a list of " + std::to_string(list->size()) + " numbers";
  return "nothing";
}

[[noreturn]] void refuse(const JobKey& key, const JobValue& value, const std::string& why) {
  throw InputError{full_name(key) + " = " + as_written(value) + ": " + why};
}

std::string unit_of(const JobKey& key) { return key.unit.empty() ? "" : " (" + std::string{key.unit} + ")"; }

std::string or_absent(const JobKey& key) {
  return key.absent.empty() ? "" : " or '" + std::string{key.absent} + "'";
}

/// Text that is one of the key's choices.
void check_choice(const JobKey& key, const JobValue& value) {
  const auto& text = std::get<std::string>(value);
  const auto choices = split_at_bars(key.choices);
  if (choices.empty() || std::ranges::find(choices, text) != choices.end()) return;
  const auto later = split_at_bars(key.later);
  if (std::ranges::find(later, text) != later.end())
    refuse(key, value, "not supported yet; there is " + spoken_list(choices));
  refuse(key, value, "not known; there is " + spoken_list(choices) + did_you_mean(text, choices));
}

double finite(const JobKey& key, const JobValue& value) {
  const double* number = std::get_if<double>(&value);
  if (number == nullptr || !std::isfinite(*number)) {
    const std::string* text = std::get_if<std::string>(&value);
    const bool comma = text != nullptr && text->find(',') != std::string::npos;
    refuse(key, value,
           "not a number" + unit_of(key) + or_absent(key) + (comma ? "; decimals follow a point: 3.5" : ""));
  }
  return *number;
}

double whole(const JobKey& key, const JobValue& value) {
  const double* given = std::get_if<double>(&value);
  const double number = given == nullptr ? std::nan("") : *given;
  if (number != std::floor(number) || !(std::abs(number) <= 1e6))
    refuse(key, value, "not a whole number" + or_absent(key));
  return number;
}

JobValue heading(const JobKey& key, const JobValue& value) {
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return finite(key, value);
  if (const auto number = number_of_text(*text)) return *number;
  const auto later = split_at_bars(key.later);
  const auto choices = split_at_bars(key.choices);
  const std::string known = "there is edge, p3 or a compass heading in degrees";
  if (std::ranges::find(choices, *text) != choices.end()) return value;
  if (std::ranges::find(later, *text) != later.end()) refuse(key, value, "not supported yet; " + known);
  refuse(key, value, "not known; " + known + did_you_mean(*text, choices));
}

JobValue line(const JobKey& key, const JobValue& value) {
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers != nullptr && numbers->empty()) return Absent{};
  if (numbers == nullptr || numbers->size() != 4 ||
      !std::ranges::all_of(*numbers, [](double x) { return std::isfinite(x); }))
    refuse(key, value, "needs four numbers: longitude and latitude of A, then of B, in degrees");
  return value;
}

JobValue list_of_text(std::string_view text) {
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const auto number = number_of_text(rest.substr(0, comma));
    if (!number) return std::string{text};
    numbers.push_back(*number);
    if (comma == rest.size()) return numbers;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace

JobValue fitted(const JobKey& key, const JobValue& value) {
  const std::string* text = std::get_if<std::string>(&value);
  if (!key.absent.empty() &&
      (std::holds_alternative<Absent>(value) || (text != nullptr && *text == key.absent)))
    return Absent{};
  switch (key.type) {
    case JobType::number:
      return finite(key, value);
    case JobType::count:
      return whole(key, value);
    case JobType::heading:
      return heading(key, value);
    case JobType::line:
      return line(key, value);
    case JobType::truth:
      if (!std::holds_alternative<bool>(value)) refuse(key, value, "neither true nor false");
      return value;
    case JobType::text:
      break;
  }
  if (text == nullptr) refuse(key, value, "not a text in quotes");
  check_choice(key, value);
  return value;
}

JobValue value_of_text(const JobKey& key, std::string_view text) {
  const std::string as_text{text};
  switch (key.type) {
    case JobType::number:
    case JobType::count:
      if (const auto number = number_of_text(text)) return fitted(key, *number);
      break;
    case JobType::truth:
      if (text == "true" || text == "yes") return true;
      if (text == "false" || text == "no") return false;
      break;
    case JobType::line:
      return fitted(key, text == key.absent ? JobValue{Absent{}} : list_of_text(text));
    case JobType::heading:
    case JobType::text:
      break;
  }
  return fitted(key, as_text);
}

std::string text_of_value(const JobKey& key, const JobValue& value) {
  if (const double* number = std::get_if<double>(&value)) return number_text(*number);
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const std::string* text = std::get_if<std::string>(&value)) {
    const auto number = key.type == JobType::heading ? number_of_text(*text) : std::nullopt;
    return number ? number_text(*number) : in_quotes(*text);
  }
  if (std::holds_alternative<Absent>(value) && key.type != JobType::line) return in_quotes(key.absent);
  std::string out = "[";
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    for (double number : *list) out += (out.size() > 1 ? ", " : "") + number_text(number);
  return out + "]";
}

}  // namespace selion
