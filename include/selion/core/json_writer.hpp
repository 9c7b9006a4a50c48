// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selion {

/// How an object or array is set out: all on the line, or each member on a line of its own, two spaces
/// deeper.
enum class JsonSpread { line, lines };

/// Writes JSON text, members in the order of the calls, numbers with fixed decimals: same calls, same bytes.
class JsonWriter {
 public:
  JsonWriter& begin_object(JsonSpread spread);
  JsonWriter& begin_array(JsonSpread spread);
  /// Closes what was begun last.
  JsonWriter& end();
  /// Names the value that comes next; in objects only.
  JsonWriter& key(std::string_view name);

  /// Bytes that are not UTF-8 become U+FFFD.
  JsonWriter& text(std::string_view value);
  JsonWriter& whole(long long value);
  /// @throws std::logic_error where `value` is not finite.
  JsonWriter& number(double value, int decimals);
  /// A value that is JSON already, taken over as it stands.
  JsonWriter& raw(std::string_view json);

  [[nodiscard]] const std::string& str() const { return out_; }

 private:
  struct Level {
    JsonSpread spread;
    char closing;
    bool empty;
  };

  void separate();
  JsonWriter& begin(char opening, char closing, JsonSpread spread);
  void new_line();

  std::string out_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace selion
