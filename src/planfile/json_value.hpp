// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace selion {

enum class JsonKind : std::uint8_t { null, boolean, whole, number, text, array, object };

/// One value of a JSON text. Those inside it stand behind it, in their order.
struct JsonValue {
  JsonKind kind = JsonKind::null;
  std::string_view key;   ///< of a member of an object
  std::string_view text;  ///< of a text, without its quotes; of a number or a word, as it stands there
  double number = 0;
  std::size_t all = 1;  ///< it and all inside it
};

/// The values of a text as a plan file's writer makes them; absent where it is not JSON, or JSON with
/// escapes, letters beyond ASCII, numbers too large or too deep a nesting for this short way of reading it.
/// Valid as long as `json`.
std::optional<std::vector<JsonValue>> plain_values(std::string_view json);

}  // namespace selion
