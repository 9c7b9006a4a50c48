// SPDX-License-Identifier: GPL-3.0-or-later
#include "findings.hpp"

#include <algorithm>
#include <cmath>

#include "selion/core/format.hpp"

namespace selion::verifying {
namespace {

constexpr int kMost = 5;

}  // namespace

std::string shown(double value, int decimals) {
  if (std::isnan(value)) return "no number of";
  return std::isinf(value) ? "infinitely many" : fixed(value, decimals);
}

void Findings::add(std::string code, int block, std::optional<Point> at, Measured measured,
                   std::string what) {
  if (++counts_[{code, block}] > kMost) return;
  Finding finding{std::move(code), std::move(what), block, std::nullopt, measured.measure, measured.limit};
  if (at && std::isfinite(at->x_m) && std::isfinite(at->y_m) && plane_.valid())
    finding.at = plane_.to_lonlat(*at);
  findings_.push_back(std::move(finding));
}

bool Findings::full(const std::string& code, int block) const {
  const auto found = counts_.find({code, block});
  return found != counts_.end() && found->second >= kMost;
}

bool Findings::any(const std::string& code) const {
  return std::ranges::any_of(findings_, [&](const Finding& f) { return f.code == code; });
}

}  // namespace selion::verifying
