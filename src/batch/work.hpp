// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "selion/batch/result.hpp"
#include "selion/batch/run.hpp"

namespace selion {

/// A field to be planned, or only what is known of one that cannot be read.
struct BatchTask {
  BatchResult row;  ///< which one it is; where there is no field, the result
  std::optional<Field> field;
};

/// Plans the field and writes its files: first into `part_folder`, then renamed.
/// @throws InputError where the files cannot be written; whatever is wrong with the field is the result.
BatchResult worked(BatchTask task, const BatchOptions& options, const std::filesystem::path& part_folder);

}  // namespace selion
