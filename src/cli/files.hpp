// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace selion::cli {

/// @throws InputError where there is no such file, or it cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace selion::cli
