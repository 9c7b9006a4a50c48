// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/format.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace selion {

void append_fixed(std::string& out, double value, int decimals) {
  if (!std::isfinite(value)) throw std::logic_error{"a number to be written is not finite"};
  std::array<char, 340>
      digits{};  // a sign, the 309 digits of the largest double, a point and 17 decimals fit
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals)
          .ptr;
  std::string_view text{digits.data(), static_cast<std::size_t>(end - digits.data())};
  const bool negative_zero = text.front() == '-' && text.find_first_not_of("-0.") == std::string_view::npos;
  if (negative_zero) text.remove_prefix(1);
  out += text;
}

std::string fixed(double value, int decimals) {
  std::string out;
  append_fixed(out, value, decimals);
  return out;
}

std::string letters_of(std::size_t index) {
  std::string out;
  for (std::size_t rest = index + 1; rest > 0; rest = (rest - 1) / 26)
    out.insert(out.begin(), static_cast<char>('a' + (rest - 1) % 26));
  return out;
}

}  // namespace selion
