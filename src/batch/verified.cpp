// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/batch/verified.hpp"

#include <optional>

#include "selion/verify/verify.hpp"

namespace selion {

Verification verification_of(const PlanFile& plan) {
  Verification said;
  for (const Finding& finding : verify(plan, std::nullopt).findings)
    said.faults.push_back(finding.code + ": " + finding.what);
  return said;
}

}  // namespace selion
