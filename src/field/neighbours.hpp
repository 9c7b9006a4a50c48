// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/field/field.hpp"

namespace selion {

/// Notes on fields that are the same as, or overlap, an earlier one of the file by more than 1 % and a
/// metre's width.
void note_neighbours(std::vector<Field>& fields);

}  // namespace selion
