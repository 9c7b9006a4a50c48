// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "check.hpp"

namespace selion::verifying {
namespace {

/// Of all metres of headland passes and swaths, taken in pairs, those of which the pass is worked first; none
/// where a drive has not both.
std::optional<double> passes_before(const Driven& driven) {
  double passes_m = 0;
  double swaths_m = 0;
  double before = 0;
  for (const PieceLine& piece : driven.pieces) {
    const PieceRecord& record = piece.record();
    if (record.tool != 1) continue;
    if (record.kind == "headland_pass") passes_m += record.length_m;
    if (record.kind != "swath") continue;
    swaths_m += record.length_m;
    before += record.length_m * passes_m;
  }
  const double pairs = passes_m * swaths_m;
  return pairs > 0 ? std::optional{before / pairs} : std::nullopt;
}

}  // namespace

/// Lines that are not reached at first are worked after all others, whatever they are: of a headland that is
/// worked last, that may be many swaths. The drive begins with what the job has first, all the same.
void check_order(Case& plan, const Driven& driven) {
  constexpr double kFew = 0.1;
  const std::string& asked = plan.vehicle.work.headland_order;
  const auto before = passes_before(driven);
  if (!before || asked == "none" || (asked == "first" ? *before >= kFew : *before <= 1 - kFew)) return;
  const auto first =
      std::ranges::find_if(driven.pieces, [](const PieceLine& p) { return p.record().tool == 1; });
  if (first->record().kind == (asked == "first" ? "headland_pass" : "swath")) return;
  plan.findings.add("headland_order", driven.record->block, first->spot(0).at,
                    {*before, asked == "first" ? kFew : 1 - kFew},
                    "the job has the headland worked " + asked + "; " + shown(100 * *before, 0) +
                        " % of it is worked before the swaths");
}

}  // namespace selion::verifying
