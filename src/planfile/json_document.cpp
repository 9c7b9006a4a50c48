// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_document.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "selion/core/error.hpp"

namespace selion {
namespace {

using Json = nlohmann::json;

/// Takes what the library reads, one after the other: a tree of nodes would fill the memory where a file is
/// but brackets. Keeps texts that the values refer to.
class ValueReader : public nlohmann::json_sax<Json> {
 public:
  ValueReader(std::vector<JsonValue>& values, std::deque<std::string>& texts, const std::string& where)
      : values_{values}, texts_{texts}, where_{where} {}

  bool null() override { return add(JsonKind::null, "null", 0); }
  bool boolean(bool value) override { return add(JsonKind::boolean, value ? "true" : "false", 0); }
  bool number_integer(number_integer_t value) override { return whole(value); }
  bool number_unsigned(number_unsigned_t value) override { return whole(value); }
  bool number_float(number_float_t value, const string_t& text) override {
    return add(JsonKind::number, kept(text), value);
  }
  bool string(string_t& text) override { return add(JsonKind::text, kept(text), 0); }
  bool binary(binary_t& /*no JSON*/) override { return false; }
  bool key(string_t& text) override {
    key_ = kept(text);
    return true;
  }
  bool start_object(std::size_t /*unknown*/) override { return begin(JsonKind::object); }
  bool end_object() override { return end(); }
  bool start_array(std::size_t /*unknown*/) override { return begin(JsonKind::array); }
  bool end_array() override { return end(); }

  bool parse_error(std::size_t byte, const std::string& /*token*/, const Json::exception& error) override {
    if (dynamic_cast<const Json::parse_error*>(&error) == nullptr)
      throw InputError{where_ + ": " + error.what() + "; no plan file holds such a value"};
    error_byte = byte;
    return false;
  }

  std::size_t error_byte = 0;

 private:
  static constexpr std::size_t kDeepest = 1000;

  std::string_view kept(const std::string& text) { return texts_.emplace_back(text); }

  bool add(JsonKind kind, std::string_view text, double number) {
    values_.push_back({.kind = kind, .key = std::exchange(key_, {}), .text = text, .number = number});
    return true;
  }
  template <class Whole>
  bool whole(Whole value) {
    return add(JsonKind::whole, kept(std::to_string(value)), static_cast<double>(value));
  }

  bool begin(JsonKind kind) {
    if (open_.size() > kDeepest)
      throw InputError{where_ + ": brackets nest too deeply; no plan file does so"};
    open_.push_back(values_.size());
    return add(kind, {}, 0);
  }
  bool end() {
    values_[open_.back()].all = values_.size() - open_.back();
    open_.pop_back();
    return true;
  }

  std::vector<JsonValue>& values_;
  std::deque<std::string>& texts_;
  const std::string& where_;
  std::string_view key_;           // of the next value
  std::vector<std::size_t> open_;  // objects and arrays that are not closed yet
};

}  // namespace

JsonDocument::JsonDocument(const std::string& text, const std::string& where)
    : where_{std::make_shared<const std::string>(where)} {
  parse(text, where);
  refuse_repeated_keys();
}

void JsonDocument::parse(const std::string& text, const std::string& where) {
  if (auto plain = plain_values(text)) {
    values_ = *std::move(plain);
    return;
  }
  ValueReader reader{values_, texts_, where};
  const bool read = Json::sax_parse(text, &reader);
  const std::size_t nul = text.find('\0');  // which the library takes for the end of the text
  if (read && nul == std::string::npos) return;
  const std::size_t byte = read ? nul + 1 : reader.error_byte;
  const std::string end = byte > text.size() ? " (the end of the file: it is cut short)" : "";
  throw InputError{where + ": byte " + std::to_string(byte) + end +
                   ": this is not JSON; plan the field anew, or fetch the file again"};
}

void JsonDocument::refuse_repeated_keys() const {
  std::vector<const JsonValue*> members;
  for (const JsonValue& value : values_) {
    if (value.kind != JsonKind::object) continue;
    members.clear();
    for (const JsonValue* member = &value + 1; member != &value + value.all; member += member->all)
      members.push_back(member);
    std::ranges::stable_sort(members, {}, &JsonValue::key);
    const auto twice = std::ranges::adjacent_find(members, {}, &JsonValue::key);
    if (twice != members.end())
      JsonNode{*(twice + 1), values_.data(), where_}.fail("is there twice; no plan file has a key twice");
  }
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
