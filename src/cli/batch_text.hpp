// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "selion/batch/run.hpp"

namespace selion::cli {

/// What a batch came to: the counts and, where its tables were written, their summary and places.
std::string text_of(const BatchCount& count, const std::string& folder);
std::string json_of(const BatchCount& count, const std::string& folder);

}  // namespace selion::cli
