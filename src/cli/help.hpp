// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "commands.hpp"

namespace selion::cli {

/// What selion is, its commands and exit statuses; lines of at most 80 characters.
std::string help_text();
/// Usage, options by group with units and defaults, examples and exit statuses of one command.
std::string help_text(const Command& command);
/// "selion 0.1.0\n"
std::string version_text();

}  // namespace selion::cli
