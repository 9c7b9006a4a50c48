// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plane.hpp"
#include "selion/verify/verify.hpp"

namespace selion::verifying {

/// What was measured, and what is allowed.
struct Measured {
  double measure = 0;
  double limit = 0;
};

/// A number for a person; what a broken plan leads to need not be finite.
std::string shown(double value, int decimals);

/// Keeps the first few of each code and block.
class Findings {
 public:
  explicit Findings(const Plane& plane) : plane_{plane} {}

  void add(std::string code, int block, std::optional<Point> at, Measured measured, std::string what);
  /// True where no more of that code and block are kept: looking for them takes time for nothing.
  [[nodiscard]] bool full(const std::string& code, int block) const;
  [[nodiscard]] bool any(const std::string& code) const;
  [[nodiscard]] std::vector<Finding> all() && { return std::move(findings_); }

 private:
  const Plane& plane_;
  std::vector<Finding> findings_;
  std::map<std::pair<std::string, int>, int> counts_;
};

}  // namespace selion::verifying
