// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_bytes.hpp"

#include <fstream>

#include "selion/core/error.hpp"
#include "selion/core/input_file.hpp"

namespace selion {

std::string file_bytes(const std::filesystem::path& path, const std::string& label) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream file{path, std::ios::binary};
  if (error || !file) refuse_unreadable(label);
  if (size > kLargestFile_bytes) refuse_too_large(label);
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(file.gcount()) < size) refuse_cut_short(label);
  return bytes;
}

void refuse_unreadable(const std::string& label) {
  throw InputError{label + " cannot be read; check the name and the permissions"};
}
void refuse_too_large(const std::string& label) {
  throw InputError{label + " is larger than 2 GB; cut out the fields to be planned"};
}
void refuse_cut_short(const std::string& label) {
  throw InputError{label + " cannot be read to its end; copy or export it anew"};
}

}  // namespace selion
