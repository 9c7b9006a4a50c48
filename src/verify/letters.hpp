// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace selion::verifying {

/// With the letters A to Z small.
std::string lower(std::string text);

}  // namespace selion::verifying
