// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "check.hpp"
#include "owner_file.hpp"

namespace selion::verifying {

/// Names that are not ASCII may be in another encoding in the owner's file.
bool is_name(const std::string& owned, const std::string& planned);
/// The owner's gates: place, name, width and number.
void check_given_gates(Case& plan, const std::vector<OwnerFeature>& features, const GivenField& given);
/// Each obstacle of the plan is one of the owner's, of the same kind and name, and none is there more often.
void check_given_kinds(Case& plan, const std::vector<OwnerFeature>& features);

}  // namespace selion::verifying
