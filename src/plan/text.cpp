// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/plan/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "selion/core/json_writer.hpp"

namespace selion {

std::string number_text(double value) {
  std::array<char, 1100> digits{};  // the smallest double has 1074 decimals
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
  const std::string text{digits.data(), end};
  return text == "-0" ? "0" : text;
}

std::optional<double> number_of_text(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (!whole || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string in_quotes(std::string_view text) { return JsonWriter{}.text(text).str(); }

}  // namespace selion
