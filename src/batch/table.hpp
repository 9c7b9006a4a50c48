// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "selion/batch/result.hpp"

namespace selion {

/// Hands every result on, in the order of their numbers.
using EachResult = std::function<void(const std::function<void(const BatchResult&)>&)>;

/// results.csv and results.gpkg of the batch in `folder`: written into `part_folder`, then renamed.
/// @throws InputError where they cannot be written.
void write_tables(const std::filesystem::path& folder, const std::filesystem::path& part_folder,
                  const EachResult& each);

}  // namespace selion
