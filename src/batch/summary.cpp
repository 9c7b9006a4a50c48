// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/batch/summary.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace selion {
namespace {

constexpr std::size_t kMostReasons = 50;  // beyond, a batch's errors are all different: told as one

/// "block 2: too narrow: a swath needs 3.6 m" is "too narrow".
std::string kind_of(const BatchResult& result) {
  if (result.status == BatchStatus::error) return "error";
  std::string_view reason = result.reason;
  while (reason.starts_with("block ") || reason.starts_with("Block ")) {
    const std::size_t colon = reason.find(": ");
    if (colon == std::string_view::npos) break;
    reason.remove_prefix(colon + 2);
  }
  reason = reason.substr(0, reason.find_first_of(":;0123456789"));
  return std::string{reason.substr(0, reason.find_last_not_of(' ') + 1)};
}

}  // namespace

void BatchSummary::take(const BatchResult& result) {
  if (!result.figures || !result.area_m2 || *result.area_m2 <= 0) {
    const std::string kind = kind_of(result);
    ++reasons_[reasons_.size() < kMostReasons || reasons_.contains(kind) ? kind : "other"];
    return;
  }
  ++planned_;
  const double tenths = std::floor(1000 * result.figures->covered_m2 / *result.area_m2);
  ++by_tenths_.at(static_cast<std::size_t>(std::clamp(tenths, 0.0, 1000.0)));
  if (result.verified.empty()) return;
  ++checked_;
  if (result.verified != "passed") ++check_failed_;
}

std::optional<double> BatchSummary::covered_percent(double share) const {
  if (planned_ == 0) return std::nullopt;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(planned_ - 1));
  std::size_t below = 0;
  std::size_t tenths = 0;
  while (below + by_tenths_.at(tenths) <= rank) below += by_tenths_.at(tenths++);
  return static_cast<double>(tenths) / 10;
}

}  // namespace selion
