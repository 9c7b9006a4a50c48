// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace selion {

/// The project's own folder.
std::filesystem::path project_dir();
/// data/, the papers' fields and constructed ones.
std::filesystem::path data_dir();
/// Real fields and broken files beside the checkout; not there everywhere.
std::filesystem::path shared_dir();

}  // namespace selion
