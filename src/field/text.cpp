// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include "selion/core/format.hpp"

namespace selion {
namespace {

/// Levenshtein 1966.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 400> buffer{};  // 1e308 has 309 digits before the point
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed).ptr;
  return {buffer.data(), end};
}

std::string place(LonLat at) {
  return fixed(std::abs(at.lon_deg), 7) + (at.lon_deg < 0 ? " W, " : " E, ") +
         fixed(std::abs(at.lat_deg), 7) + (at.lat_deg < 0 ? " S" : " N");
}

std::string lower(std::string_view text) {
  std::string copy{text};
  for (char& c : copy)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return copy;
}

std::string nearest_names(std::vector<std::string> names, std::string_view wanted) {
  constexpr std::size_t kMost = 5;
  const std::string target = lower(wanted);
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return edits(lower(a), target) < edits(lower(b), target);
  });
  std::string list;
  for (std::size_t i = 0; i < std::min(kMost, names.size()); ++i)
    list += (i == 0 ? "'" : ", '") + names[i] + "'";
  return names.size() > kMost ? list + ", ..." : list;
}

}  // namespace selion
