// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "selion/batch/run.hpp"

namespace selion {

/// The tables of journals that are complete and belong together.
BatchCount write_tables_of(const std::filesystem::path& folder,
                           const std::vector<std::filesystem::path>& journals,
                           const std::filesystem::path& part_folder);

}  // namespace selion
