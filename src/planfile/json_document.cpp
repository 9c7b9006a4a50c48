// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_document.hpp"

#include <nlohmann/json.hpp>

#include "selion/core/error.hpp"

namespace selion {
namespace {

using Json = nlohmann::json;

Json parsed(const std::string& text, const std::string& where) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    const std::string end = error.byte > text.size() ? " (the end of the file: it is cut short)" : "";
    throw InputError{where + ": byte " + std::to_string(error.byte) + end +
                     ": this is not JSON; plan the field anew, or fetch the file again"};
  } catch (const Json::exception& error) {
    throw InputError{where + ": " + error.what() + "; no plan file holds such a value"};
  }
}

/// Turns what the library has read into values; keeps texts that they refer to.
class Flattened {
 public:
  Flattened(std::vector<JsonValue>& values, std::deque<std::string>& texts, const std::string& where)
      : values_{values}, texts_{texts}, where_{where} {}

  void add(const Json& json, std::string_view key, int depth) {
    constexpr int kDeepest = 1000;
    if (depth > kDeepest) throw InputError{where_ + ": brackets nest too deeply; no plan file does so"};
    const std::size_t self = values_.size();
    values_.push_back({.kind = kind_of(json), .key = key, .text = {}});
    if (json.is_string()) values_[self].text = texts_.emplace_back(json.get_ref<const std::string&>());
    if (json.is_primitive() && !json.is_string()) values_[self].text = texts_.emplace_back(json.dump());
    if (json.is_number()) values_[self].number = json.get<double>();
    if (json.is_array())
      for (const Json& item : json) add(item, {}, depth + 1);
    if (json.is_object())
      for (const auto& member : json.items())
        add(member.value(), texts_.emplace_back(member.key()), depth + 1);
    values_[self].all = values_.size() - self;
  }

 private:
  static JsonKind kind_of(const Json& json) {
    if (json.is_object()) return JsonKind::object;
    if (json.is_array()) return JsonKind::array;
    if (json.is_string()) return JsonKind::text;
    if (json.is_number_integer()) return JsonKind::whole;
    if (json.is_number()) return JsonKind::number;
    return json.is_boolean() ? JsonKind::boolean : JsonKind::null;
  }

  std::vector<JsonValue>& values_;
  std::deque<std::string>& texts_;
  const std::string& where_;
};

}  // namespace

JsonDocument::JsonDocument(const std::string& text, const std::string& where)
    : where_{std::make_shared<const std::string>(where)} {
  if (auto plain = plain_values(text)) {
    values_ = *std::move(plain);
    return;
  }
  Flattened{values_, texts_, where}.add(parsed(text, where), {}, 0);
}

std::string named(const JsonValue& value) {
  switch (value.kind) {
    case JsonKind::object:
      return "of type object";
    case JsonKind::array:
      return "of type array";
    case JsonKind::text:
      return "of type string";
    default:
      return Json::parse(value.text).dump();  // 1.50 is 1.5
  }
}

bool is_json_object(const std::string& text) {
  constexpr bool kNoExceptions = false;
  return Json::parse(text, nullptr, kNoExceptions).is_object();
}

}  // namespace selion
