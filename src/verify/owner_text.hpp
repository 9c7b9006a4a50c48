// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "owner_crs.hpp"
#include "selion/planfile/planfile.hpp"
#include "selion/verify/verify.hpp"

namespace selion::verifying {

/// Whether a file with that ending is read as coordinates, one position a line.
bool is_coordinate_text(const std::filesystem::path& file);

/// The field of such a file: its first ring is the border, the others are holes.
/// @throws InputError naming the line that holds no position.
LonLatArea read_coordinate_text(const std::filesystem::path& file, TextOrder order, const ToWgs84& to_wgs84);

}  // namespace selion::verifying
