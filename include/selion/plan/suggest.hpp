// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace selion {

/// The fewest letters to add, drop, change or swap with a neighbour to get from `a` to `b`.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, the first of equal ones; empty where none is near enough to be meant.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean 'p3'?" or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// The parts of a list written with bars: "A4|A3|letter".
std::vector<std::string_view> split_at_bars(std::string_view list);

/// "A4, A3 or letter".
std::string spoken_list(std::span<const std::string_view> words);

}  // namespace selion
