// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_value.hpp"
#include "selion/core/point.hpp"

namespace selion {

/// One value in a parsed JSON text and its place there: whatever is asked of it and is not so throws an
/// InputError that names the place. Valid as long as its document.
class JsonNode {
 public:
  /// The member `key` of an object; it must be there.
  [[nodiscard]] JsonNode at(std::string_view key) const;
  [[nodiscard]] std::optional<JsonNode> find(std::string_view key) const;
  /// Of an object, in the order of the file.
  [[nodiscard]] std::vector<std::pair<std::string_view, JsonNode>> members() const;
  [[nodiscard]] std::vector<JsonNode> items() const;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] int whole(int low) const;
  [[nodiscard]] std::vector<double> numbers() const;
  [[nodiscard]] std::vector<int> wholes(int low) const;
  /// [longitude, latitude]
  [[nodiscard]] LonLat position() const;
  [[nodiscard]] std::vector<LonLat> positions() const;

  /// The same value, called `place` in messages: "feature 3 (swath)".
  [[nodiscard]] JsonNode called(const std::string& place) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  friend class JsonDocument;
  JsonNode(const JsonValue* value, const JsonValue* top, std::shared_ptr<const std::string> place)
      : value_{value}, top_{top}, place_{std::move(place)} {}
  [[nodiscard]] JsonNode item(const JsonValue& value) const { return {&value, top_, place_}; }
  [[nodiscard]] std::string path() const;  // "properties.pieces[4].gear"
  [[noreturn]] void fail_at(const std::string& path, const std::string& what) const;
  void must_be(bool right, const char* what) const;

  const JsonValue* value_;
  const JsonValue* top_;                      // where the path to it begins
  std::shared_ptr<const std::string> place_;  // "plan.geojson: feature 3 (swath)"
};

}  // namespace selion
