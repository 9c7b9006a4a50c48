// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "selion/core/error.hpp"
#include "selion/core/input_file.hpp"

namespace selion::cli {

std::string text_of_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw InputError{file.string() + ": is a folder, not a file"};
  refuse_endless(file);
  if (const auto size = std::filesystem::file_size(file, ignored); !ignored && size > kLargestFile_bytes)
    throw InputError{file.string() + " is larger than 2 GB; no plan and no job is"};
  errno = 0;
  std::ifstream stream{file, std::ios::binary};
  std::string text = std::filesystem::is_regular_file(file, ignored)
                         ? std::string{std::istreambuf_iterator<char>{stream}, {}}
                         : text_of_stream(stream, file.string());
  if (!stream.is_open() || stream.bad())
    throw InputError{file.string() + ": cannot be read: " + std::generic_category().message(errno)};
  return text;
}

}  // namespace selion::cli
