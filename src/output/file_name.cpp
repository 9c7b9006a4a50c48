// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/output/file_name.hpp"

#include <algorithm>

namespace selion {
namespace {

bool is_unsafe(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte <= 0x20 || byte == 0x7f ||
         std::string_view{"/\\:*?\"<>|'`$&;(){}[]!#~^%"}.find(c) != std::string_view::npos;
}

/// How many bytes of `text` are one character of UTF-8; 0 where they are none.
std::size_t character_bytes(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return 1;
  const std::size_t size = lead >= 0xf0 && lead < 0xf5 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 0;
  if (size == 0 || lead >= 0xf5 || text.size() < size) return 0;
  const auto follows = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
  return std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(size), follows) ? size : 0;
}

}  // namespace

std::string folder_name(int number, std::string_view field_name) {
  constexpr std::size_t kLongest = 100;
  std::string name = std::to_string(number) + "_";
  const std::size_t start = name.size();
  while (!field_name.empty()) {
    const std::size_t size = character_bytes(field_name);
    const bool safe = size > 0 && !(size == 1 && is_unsafe(field_name.front()));
    const std::string_view part = safe ? field_name.substr(0, size) : "_";
    if (name.size() + part.size() > kLongest) break;
    const bool again = part == "_" && name.ends_with('_');
    if (!again) name += part;
    field_name.remove_prefix(std::max<std::size_t>(size, 1));
  }
  while (name.size() > start && (name.ends_with('_') || name.ends_with('.'))) name.pop_back();
  if (name.size() == start) name.pop_back();
  return name;
}

}  // namespace selion
