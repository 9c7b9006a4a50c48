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

/// What is to be added to a path.
std::string joined(const std::string& path, std::string_view key) {
  return (path.empty() ? "" : ".") + std::string{key};
}

std::string must_be_text(const char* what, const JsonValue& value) {
  return std::string{"must be "} + what + ", not " + named(value);
}

}  // namespace

std::string JsonNode::path() const {
  std::string path;
  for (const JsonValue* outer = top_; outer != value_;) {
    std::size_t i = 0;
    const JsonValue* inner = outer + 1;
    for (; inner + inner->all <= value_; inner += inner->all) ++i;
    path += outer->kind == JsonKind::array ? "[" + std::to_string(i) + "]" : joined(path, inner->key);
    outer = inner;
  }
  return path;
}

void JsonNode::fail(const std::string& what) const { fail_at(path(), what); }

void JsonNode::fail_at(const std::string& path, const std::string& what) const {
  throw InputError{*place_ + ": " + (path.empty() ? "" : "\"" + path + "\" ") + what};
}

void JsonNode::must_be(bool right, const char* what) const {
  if (!right) fail(must_be_text(what, *value_));
}

JsonNode JsonNode::called(const std::string& place) const {
  return {value_, value_, std::make_shared<const std::string>(place)};
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  must_be(value_->kind == JsonKind::object, "an object");
  const JsonValue* member = nullptr;
  for_each_in(*value_, [&](const JsonValue& value) {
    if (value.key == key) member = &value;
  });
  if (member == nullptr) return std::nullopt;
  return item(*member);
}

JsonNode JsonNode::at(std::string_view key) const {
  if (auto member = find(key)) return *std::move(member);
  const std::string outer = path();
  fail_at(outer + joined(outer, key), "is missing");
}

std::vector<std::pair<std::string_view, JsonNode>> JsonNode::members() const {
  must_be(value_->kind == JsonKind::object, "an object");
  std::vector<std::pair<std::string_view, JsonNode>> out;
  for_each_in(*value_, [&](const JsonValue& value) { out.emplace_back(value.key, item(value)); });
  return out;
}

std::vector<JsonNode> JsonNode::items() const {
  must_be(value_->kind == JsonKind::array, "an array");
  std::vector<JsonNode> out;
  for_each_in(*value_, [&](const JsonValue& value) { out.push_back(item(value)); });
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
    out.push_back(is_number(value) ? value.number : item(value).number());
  });
  return out;
}

std::vector<int> JsonNode::wholes(int low) const {
  must_be(value_->kind == JsonKind::array, "an array");
  std::vector<int> out;
  out.reserve(value_->all - 1);
  for_each_in(*value_, [&](const JsonValue& value) {
    out.push_back(is_whole(value, low) ? static_cast<int>(value.number) : item(value).whole(low));
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
    out.push_back(is_position(value) ? position_of(value) : item(value).position());
  });
  return out;
}

}  // namespace selion
