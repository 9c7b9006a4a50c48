// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace selion {

/// Of the library, "0.1.0": set once, in CMakeLists.txt.
std::string_view version();

}  // namespace selion
