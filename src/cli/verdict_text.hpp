// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "selion/verify/verify.hpp"

namespace selion::cli {

std::string text_of(const Verdict& verdict, const WatchList& watch, const std::string& plan);
std::string json_of(const Verdict& verdict, const std::vector<VerifiedPlace>& twice, const WatchList& watch);

}  // namespace selion::cli
