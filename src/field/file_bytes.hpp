// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace selion {

/// A whole file. @throws InputError, calling it `label`, where it cannot be read or is beyond 2 GB.
std::string file_bytes(const std::filesystem::path& path, const std::string& label);

/// The refusals of a file, also of one in an archive.
[[noreturn]] void refuse_unreadable(const std::string& label);
[[noreturn]] void refuse_too_large(const std::string& label);
[[noreturn]] void refuse_cut_short(const std::string& label);

}  // namespace selion
