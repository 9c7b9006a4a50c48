// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace selion {

// Both take valid JSON.

/// The value of the member `key` of the object that `json` starts with, escapes in keys as they stand; of
/// several the last one, empty where there is none.
std::string_view raw_member(std::string_view json, std::string_view key);

/// `json` without the white space between its tokens.
std::string compacted(std::string_view json);

}  // namespace selion
