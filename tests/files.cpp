// SPDX-License-Identifier: GPL-3.0-or-later
// The only source that knows where the checkout lies: the others compile to the same anywhere.
#include "files.hpp"

namespace selion {

std::filesystem::path project_dir() { return SELION_PROJECT_DIR; }
std::filesystem::path data_dir() { return project_dir() / "data"; }
std::filesystem::path shared_dir() { return project_dir() / ".." / "shared"; }

}  // namespace selion
