// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_value.hpp"

#include <charconv>
#include <system_error>

namespace selion {
namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kBytesAValue = 8;  // of a plan: what is reserved need not be copied

bool is_digit(char c) { return c >= '0' && c <= '9'; }

class PlainParser {
 public:
  explicit PlainParser(std::string_view json) : json_{json} { values_.reserve(json.size() / kBytesAValue); }

  std::optional<std::vector<JsonValue>> parsed() && {
    if (!value({}, 0)) return std::nullopt;
    skip_space();
    if (at_ != json_.size()) return std::nullopt;
    return std::move(values_);
  }

 private:
  [[nodiscard]] char next() const { return at_ < json_.size() ? json_[at_] : '\0'; }
  void skip_space() {
    while (next() == ' ' || next() == '\n' || next() == '\t' || next() == '\r') ++at_;
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }

  // Each of these is true where it took what it is named after.

  bool value(std::string_view key, int depth) {
    skip_space();
    switch (next()) {
      case '{':
        return members(key, depth);
      case '[':
        return items(key, depth);
      case '"': {
        const auto word = text();
        if (word) values_.push_back({.kind = JsonKind::text, .key = key, .text = *word});
        return word.has_value();
      }
      case 't':
        return word("true", {.kind = JsonKind::boolean, .key = key, .text = {}, .number = 1});
      case 'f':
        return word("false", {.kind = JsonKind::boolean, .key = key, .text = {}});
      case 'n':
        return word("null", {.kind = JsonKind::null, .key = key, .text = {}});
      default:
        return number(key);
    }
  }

  bool members(std::string_view key, int depth) {
    const std::size_t self = begin(JsonKind::object, key);
    if (take('}')) return true;
    do {
      skip_space();
      const auto name = next() == '"' ? text() : std::nullopt;
      skip_space();
      if (!name || !take(':') || depth == kDeepest || !value(*name, depth + 1)) return false;
      skip_space();
    } while (take(','));
    values_[self].all = values_.size() - self;
    return take('}');
  }

  bool items(std::string_view key, int depth) {
    const std::size_t self = begin(JsonKind::array, key);
    if (take(']')) return true;
    do {
      if (depth == kDeepest || !value({}, depth + 1)) return false;
      skip_space();
    } while (take(','));
    values_[self].all = values_.size() - self;
    return take(']');
  }

  std::size_t begin(JsonKind kind, std::string_view key) {
    ++at_;
    values_.push_back({.kind = kind, .key = key, .text = {}});
    skip_space();
    return values_.size() - 1;
  }

  /// On its opening quote.
  std::optional<std::string_view> text() {
    const std::size_t first = ++at_;
    while (next() >= ' ' && next() <= '~' && next() != '"' && next() != '\\') ++at_;
    if (!take('"')) return std::nullopt;
    return json_.substr(first, at_ - 1 - first);
  }

  bool word(std::string_view name, JsonValue value) {
    if (json_.substr(at_, name.size()) != name) return false;
    value.text = json_.substr(at_, name.size());
    at_ += name.size();
    values_.push_back(value);
    return true;
  }

  bool digits() {
    const std::size_t first = at_;
    while (is_digit(next())) ++at_;
    return at_ > first;
  }

  bool number(std::string_view key) {
    const std::size_t first = at_;
    take('-');
    if (!take('0') && !digits()) return false;
    JsonKind kind = JsonKind::whole;
    if (take('.')) {
      kind = JsonKind::number;
      if (!digits()) return false;
    }
    if (take('e') || take('E')) {
      kind = JsonKind::number;
      if (!take('+')) take('-');
      if (!digits()) return false;
    }
    double number = 0;
    const auto read = std::from_chars(json_.data() + first, json_.data() + at_, number);
    if (read.ec != std::errc{} || read.ptr != json_.data() + at_) return false;
    if (kind == JsonKind::whole) number += 0.0;  // of whole numbers there is one zero
    values_.push_back({.kind = kind, .key = key, .text = json_.substr(first, at_ - first), .number = number});
    return true;
  }

  std::string_view json_;
  std::size_t at_ = 0;
  std::vector<JsonValue> values_;
};

}  // namespace

std::optional<std::vector<JsonValue>> plain_values(std::string_view json) {
  return PlainParser{json}.parsed();
}

}  // namespace selion
