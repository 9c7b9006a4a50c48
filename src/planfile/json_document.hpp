// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "json_node.hpp"
#include "json_value.hpp"

namespace selion {

class JsonDocument {
 public:
  /// Of a text that outlives it.
  /// @throws InputError where `text` is not JSON, naming `where` and the byte, or where an object has a key
  /// twice: readers differ in which one they take.
  JsonDocument(const std::string& text, const std::string& where);
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;
  JsonDocument(JsonDocument&&) = delete;
  JsonDocument& operator=(JsonDocument&&) = delete;
  ~JsonDocument() = default;

  [[nodiscard]] JsonNode root() const { return {values_.data(), values_.data(), where_}; }

 private:
  void parse(const std::string& text, const std::string& where);
  void refuse_repeated_keys() const;

  std::shared_ptr<const std::string> where_;
  std::vector<JsonValue> values_;
  std::deque<std::string> texts_;  ///< that do not stand in the file as they are meant
};

/// What stands there, for a message: a number or word itself, of anything else its type.
std::string named(const JsonValue& value);

bool is_json_object(const std::string& text);

}  // namespace selion
