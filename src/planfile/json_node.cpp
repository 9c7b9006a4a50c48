// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_node.hpp"

#include <limits>

#include <nlohmann/json.hpp>

#include "selion/core/error.hpp"

namespace selion {
namespace {

using Json = nlohmann::json;

const Json& json(const void* value) { return *static_cast<const Json*>(value); }

bool is_whole(const Json& value, int low) {
  return value.is_number_integer() && value >= low && value <= std::numeric_limits<int>::max();
}

bool is_position(const Json& value) {
  return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

LonLat position_of(const Json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

std::string must_be_text(const char* what, const Json& value) {
  const bool is_short = value.is_primitive() && !value.is_string();
  return std::string{"must be "} + what + ", not " +
         (is_short ? value.dump() : std::string{"of type "} + value.type_name());
}

}  // namespace

void JsonNode::fail(const std::string& what) const {
  throw InputError{place_ + ": " + (path_.empty() ? "" : "\"" + path_ + "\" ") + what};
}

void JsonNode::must_be(bool right, const char* what) const {
  if (!right) fail(must_be_text(what, json(value_)));
}

JsonNode JsonNode::called(const std::string& place) const { return {value_, place, ""}; }

JsonNode JsonNode::item(const void* value, std::size_t i) const {
  return {value, place_, path_ + "[" + std::to_string(i) + "]"};
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  must_be(json(value_).is_object(), "an object");
  const auto member = json(value_).find(std::string{key});
  if (member == json(value_).end()) return std::nullopt;
  return JsonNode{&*member, place_, path_.empty() ? std::string{key} : path_ + "." + std::string{key}};
}

JsonNode JsonNode::at(std::string_view key) const {
  if (auto member = find(key)) return *std::move(member);
  const std::string path = path_.empty() ? std::string{key} : path_ + "." + std::string{key};
  JsonNode{nullptr, place_, path}.fail("is missing");
}

std::vector<JsonNode> JsonNode::items() const {
  must_be(json(value_).is_array(), "an array");
  std::vector<JsonNode> out;
  for (const Json& value : json(value_)) out.push_back(item(&value, out.size()));
  return out;
}

std::string JsonNode::text() const {
  must_be(json(value_).is_string(), "a string");
  return json(value_).get<std::string>();
}

double JsonNode::number() const {
  must_be(json(value_).is_number(), "a number");
  return json(value_).get<double>();
}

int JsonNode::whole(int low) const {
  if (!is_whole(json(value_), low)) {
    const std::string what = "a whole number of at least " + std::to_string(low);
    fail(must_be_text(what.c_str(), json(value_)));
  }
  return json(value_).get<int>();
}

std::vector<double> JsonNode::numbers() const {
  must_be(json(value_).is_array(), "an array");
  std::vector<double> out;
  out.reserve(json(value_).size());
  for (const Json& value : json(value_))
    out.push_back(value.is_number() ? value.get<double>() : item(&value, out.size()).number());
  return out;
}

std::vector<int> JsonNode::wholes(int low) const {
  must_be(json(value_).is_array(), "an array");
  std::vector<int> out;
  out.reserve(json(value_).size());
  for (const Json& value : json(value_))
    out.push_back(is_whole(value, low) ? value.get<int>() : item(&value, out.size()).whole(low));
  return out;
}

LonLat JsonNode::position() const {
  must_be(is_position(json(value_)), "a position [longitude, latitude]");
  return position_of(json(value_));
}

std::vector<LonLat> JsonNode::positions() const {
  must_be(json(value_).is_array(), "an array of positions");
  std::vector<LonLat> out;
  out.reserve(json(value_).size());
  for (const Json& value : json(value_))
    out.push_back(is_position(value) ? position_of(value) : item(&value, out.size()).position());
  return out;
}

struct JsonDocument::Held {
  Json root;
};

JsonDocument::JsonDocument(const std::string& text, const std::string& where) : where_{where} {
  try {
    held_ = std::make_unique<Held>(Held{Json::parse(text)});
  } catch (const Json::parse_error& error) {
    const std::string end = error.byte > text.size() ? " (the end of the file: it is cut short)" : "";
    throw InputError{where + ": byte " + std::to_string(error.byte) + end +
                     ": this is not JSON; plan the field anew, or fetch the file again"};
  } catch (const Json::exception& error) {
    throw InputError{where + ": " + error.what() + "; no plan file holds such a value"};
  }
}

JsonDocument::~JsonDocument() = default;

JsonNode JsonDocument::root() const { return {&held_->root, where_, ""}; }

bool is_json_object(const std::string& text) {
  constexpr bool kNoExceptions = false;
  return Json::parse(text, nullptr, kNoExceptions).is_object();
}

}  // namespace selion
