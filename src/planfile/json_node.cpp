// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_node.hpp"

#include <limits>

#include "json_document.hpp"
#include "selion/core/error.hpp"

namespace selion {
namespace {

bool is_number(const JsonValue& value) {
  return value.kind == JsonKind::number || value.kind == JsonKind::whole;
}

bool is_whole(const JsonValue& value, int low) {
  return value.kind == JsonKind::whole && value.number >= low &&
         value.number <= std::numeric_limits<int>::max();
}

/// Calls `use` with each value that stands in an array or object itself.
template <class Use>
void for_each_in(const JsonValue& value, Use use) {
  const JsonValue* end = &value + value.all;
  for (const JsonValue* inner = &value + 1; inner != end; inner += inner->all) use(*inner);
}

bool is_position(const JsonValue& value) {
  return value.kind == JsonKind::array && value.all == 3 && is_number((&value)[1]) && is_number((&value)[2]);
}

LonLat position_of(const JsonValue& value) { return {(&value)[1].number, (&value)[2].number}; }

std::string must_be_text(const char* what, const JsonValue& value) {
  return std::string{"must be "} + what + ", not " + named(value);
}

}  // namespace

void JsonNode::fail(const std::string& what) const {
  throw InputError{place_ + ": " + (path_.empty() ? "" : "\"" + path_ + "\" ") + what};
}

void JsonNode::must_be(bool right, const char* what) const {
  if (!right) fail(must_be_text(what, *value_));
}

JsonNode JsonNode::called(const std::string& place) const { return {value_, place, ""}; }

JsonNode JsonNode::item(const JsonValue& value, std::size_t i) const {
  return {&value, place_, path_ + "[" + std::to_string(i) + "]"};
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  must_be(value_->kind == JsonKind::object, "an object");
  const JsonValue* member = nullptr;
  for_each_in(*value_, [&](const JsonValue& value) {
    if (value.key == key) member = &value;  // of several the last one
  });
  if (member == nullptr) return std::nullopt;
  return JsonNode{member, place_, path_.empty() ? std::string{key} : path_ + "." + std::string{key}};
}

JsonNode JsonNode::at(std::string_view key) const {
  if (auto member = find(key)) return *std::move(member);
  const std::string path = path_.empty() ? std::string{key} : path_ + "." + std::string{key};
  JsonNode{nullptr, place_, path}.fail("is missing");
}

std::vector<JsonNode> JsonNode::items() const {
  must_be(value_->kind == JsonKind::array, "an array");
  std::vector<JsonNode> out;
  for_each_in(*value_, [&](const JsonValue& value) { out.push_back(item(value, out.size())); });
  return out;
}

std::string JsonNode::text() const {
  must_be(value_->kind == JsonKind::text, "a string");
  return std::string{value_->text};
}

double JsonNode::number() const {
  must_be(is_number(*value_), "a number");
  return value_->number;
}

int JsonNode::whole(int low) const {
  if (!is_whole(*value_, low)) {
    const std::string what = "a whole number of at least " + std::to_string(low);
    fail(must_be_text(what.c_str(), *value_));
  }
  return static_cast<int>(value_->number);
}

std::vector<double> JsonNode::numbers() const {
  must_be(value_->kind == JsonKind::array, "an array");
  std::vector<double> out;
  out.reserve(value_->all - 1);
  for_each_in(*value_, [&](const JsonValue& value) {
    out.push_back(is_number(value) ? value.number : item(value, out.size()).number());
  });
  return out;
}

std::vector<int> JsonNode::wholes(int low) const {
  must_be(value_->kind == JsonKind::array, "an array");
  std::vector<int> out;
  out.reserve(value_->all - 1);
  for_each_in(*value_, [&](const JsonValue& value) {
    out.push_back(is_whole(value, low) ? static_cast<int>(value.number) : item(value, out.size()).whole(low));
  });
  return out;
}

LonLat JsonNode::position() const {
  must_be(is_position(*value_), "a position [longitude, latitude]");
  return position_of(*value_);
}

std::vector<LonLat> JsonNode::positions() const {
  must_be(value_->kind == JsonKind::array, "an array of positions");
  std::vector<LonLat> out;
  out.reserve(value_->all / 3);
  for_each_in(*value_, [&](const JsonValue& value) {
    out.push_back(is_position(value) ? position_of(value) : item(value, out.size()).position());
  });
  return out;
}

}  // namespace selion
