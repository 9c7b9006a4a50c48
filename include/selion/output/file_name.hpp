// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace selion {

/// "7_Long_acre": a name that any file system takes, whatever the field is called; at most 100 bytes.
std::string folder_name(int number, std::string_view field_name);

}  // namespace selion
