// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/input_file.hpp"

#include <string>

#include "selion/core/error.hpp"

namespace selion {
namespace {

bool is_opened_already(const std::string& path) {
  return path == "/dev/stdin" || path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
}

}  // namespace

void refuse_endless(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (!std::filesystem::is_other(status)) return;
  const bool pipe = std::filesystem::is_fifo(status);
  if (pipe && is_opened_already(path.string())) return;
  throw InputError{path.string() + " is " + (pipe ? "a named pipe" : "a device or socket") +
                   ", which may never end; give a file, or for a field or plan -, standard input"};
}

std::string text_of_stream(std::istream& stream, const std::string& label) {
  constexpr std::size_t kSome_bytes = 1U << 16U;
  std::string text;
  std::string some(kSome_bytes, '\0');
  while (stream.read(some.data(), static_cast<std::streamsize>(some.size())), stream.gcount() > 0) {
    text.append(some, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kLongestStream_bytes)
      throw InputError{label + " does not end within 256 MB; give what is longer as a file"};
  }
  return text;
}

}  // namespace selion
