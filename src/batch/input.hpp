// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "selion/batch/journal.hpp"
#include "selion/batch/run.hpp"

namespace selion {

struct InputFile {
  std::filesystem::path path;
  std::string name;  ///< below the folder that was given
};

/// The file, or all field files of the folder and those below, by name; what is hidden or lies in
/// `batch_folder` is none.
/// @throws InputError where there is none, or the two folders are one.
std::vector<InputFile> input_files(const std::filesystem::path& fields,
                                   const std::filesystem::path& batch_folder);

/// @throws InputError where a file of obstacles or gates cannot be read.
BatchIdentity identity_of(const BatchOptions& options, const std::vector<InputFile>& files);

}  // namespace selion
