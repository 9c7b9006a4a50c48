// SPDX-License-Identifier: GPL-3.0-or-later
#include "check.hpp"

namespace selion::verifying {
namespace {

/// Every record names a block that there is.
template <class Record>
void check_blocks(Case& plan, const std::vector<Record>& records, const std::string& kind) {
  for (const Record& record : records)
    if (plan.ground(record.block) == nullptr)
      plan.findings.add("block", 0, std::nullopt,
                        {1.0 * record.block, 1.0 * static_cast<double>(plan.grounds.size())},
                        kind + " is said to be of block " + std::to_string(record.block) +
                            "; the field has " + std::to_string(plan.grounds.size()));
}

}  // namespace

void check_records(Case& plan) {
  const PlanFile& file = plan.plan;
  check_blocks(plan, file.obstacles, "an obstacle");
  check_blocks(plan, file.gates, "a gate");
  check_blocks(plan, file.cells, "a cell");
  check_blocks(plan, file.ab_lines, "an AB line");
  check_blocks(plan, file.headlands, "a headland");
  check_blocks(plan, file.headland_passes, "a headland pass");
  check_blocks(plan, file.swaths, "a swath");
}

}  // namespace selion::verifying
