// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/format.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace selion {
namespace {

/// The value in units of its last decimal, rounded: absent where the product's own rounding might decide.
std::optional<std::uint64_t> in_last_decimals(double magnitude, int decimals) {
  constexpr auto kPowers = std::to_array<double>({1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9});
  constexpr double kMost = 0x1p50;
  if (decimals < 0 || static_cast<std::size_t>(decimals) >= kPowers.size()) return std::nullopt;
  const double units = magnitude * kPowers[static_cast<std::size_t>(decimals)];
  if (!(units < kMost)) return std::nullopt;
  const double below = std::floor(units);
  const double beyond_half = units - below - 0.5;
  if (std::abs(beyond_half) <= units * 0x1p-52) return std::nullopt;
  return static_cast<std::uint64_t>(below) + (beyond_half > 0 ? 1 : 0);
}

void append_units(std::string& out, bool negative, std::uint64_t units, int decimals) {
  std::array<char, 24> digits{};
  char* const end = digits.data() + digits.size();
  char* begin = end;
  int written = 0;
  if (negative && units == 0) negative = false;
  do {
    *--begin = static_cast<char>('0' + units % 10);
    units /= 10;
    if (++written == decimals) *--begin = '.';
  } while (units > 0 || written <= decimals);
  if (negative) *--begin = '-';
  out.append(begin, end);
}

}  // namespace

void append_fixed(std::string& out, double value, int decimals) {
  if (!std::isfinite(value)) throw std::logic_error{"a number to be written is not finite"};
  // nearly every number: several times as fast as to_chars, which is exact for all
  if (const auto units = in_last_decimals(std::abs(value), decimals))
    return append_units(out, std::signbit(value), *units, decimals);
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
