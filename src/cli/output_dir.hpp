// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace selion::cli {

struct OutputFile {
  std::string name;
  std::string bytes;
};

enum class Existing { refuse, replace };

/// @throws InputError where `folder` cannot be made or written, or holds a file of these names that is not to
/// be replaced.
void check_output(const std::filesystem::path& folder, std::span<const std::string_view> names,
                  Existing existing);

/// Writes all files or none: beside their names first, then renamed; makes `folder`, and removes it again
/// where that failed.
/// @throws InputError naming the file and why.
void write_output(const std::filesystem::path& folder, std::span<const OutputFile> files, Existing existing);

}  // namespace selion::cli
