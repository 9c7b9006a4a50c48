// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "selion/core/point.hpp"

namespace selion {

/// The shortest text without an exponent that reads back as the same double.
std::string shortest(double value);
/// "8.1234567 E, 54.1234567 N": a place that a map takes.
std::string place(LonLat at);
std::string lower(std::string_view text);
/// At most five of `names`, those spelled most like `wanted` first.
std::string nearest_names(std::vector<std::string> names, std::string_view wanted);

}  // namespace selion
