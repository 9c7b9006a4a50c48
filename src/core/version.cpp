// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/version.hpp"

namespace selion {

std::string_view version() { return SELION_VERSION; }

}  // namespace selion
