// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace selion::verifying {

/// Keys of a job that docs/job.md does not name, "machine.colour". What they ask for, nobody has planned.
std::vector<std::string> unknown_keys(const std::string& job_json);

}  // namespace selion::verifying
