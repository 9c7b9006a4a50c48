// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selion {

// All of these take valid JSON.

struct RawMember {
  std::string_view key;  ///< without its quotes, escapes as they stand
  std::string_view value;
};

/// The members of the object that `json` starts with, in their order.
std::vector<RawMember> raw_members(std::string_view json);

/// The value of the member `key`; of several the last one, empty where there is none.
std::string_view raw_member(std::string_view json, std::string_view key);

/// `json` without the white space between its tokens.
std::string compacted(std::string_view json);

}  // namespace selion
