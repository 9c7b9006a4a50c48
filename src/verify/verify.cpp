// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/verify/verify.hpp"

#include "taken_apart.hpp"

namespace selion {

using namespace verifying;

Verdict verify(const PlanFile& file, const std::optional<GivenField>& given) {
  TakenApart taken{file};
  Verdict verdict;
  if (taken.usable()) {
    Case& plan = taken.plan();
    if (given) check_given(plan, *given);
    for (Driven& driven : plan.drives) {
      check_joints(plan, driven);
      check_bends(plan, driven);
      check_samples(plan, driven);
      check_speeds(plan, driven);
      check_stops(plan, driven);
      check_tool(plan, driven);
      check_inside(plan, driven);
      check_margin(plan, driven);
      check_order(plan, driven);
    }
    check_records(plan);
    check_gates(plan);
    check_kinds(plan);
    check_lines(plan);
    check_ab(plan);
    check_headlands(plan);
    check_rings(plan);
    check_waits(plan);
    check_robots(plan);
    check_coverage(plan, verdict);
    check_summary(plan, verdict);
  }
  verdict.findings = std::move(taken).findings();
  return verdict;
}

std::vector<VerifiedPlace> worked_twice(const PlanFile& plan) {
  TakenApart taken{plan};
  return taken.usable() ? places_worked_twice(taken.plan()) : std::vector<VerifiedPlace>{};
}

}  // namespace selion
