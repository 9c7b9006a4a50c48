// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "selion/batch/result.hpp"

namespace selion {

/// A batch's table in a few figures: how well the fields with a plan are covered, why others have none, what
/// the independent check says. Takes the same room for any number of fields.
class BatchSummary {
 public:
  void take(const BatchResult& result);

  [[nodiscard]] std::size_t planned() const { return planned_; }
  [[nodiscard]] std::size_t checked() const { return checked_; }
  [[nodiscard]] std::size_t check_failed() const { return check_failed_; }
  /// So much or less is covered of a `share` (0 to 1) of the fields with a plan, to a tenth of a percent; of
  /// the least covered one for 0. Absent without plans.
  [[nodiscard]] std::optional<double> covered_percent(double share) const;
  /// Of fields without a plan: the reason up to its figures, and how many there are.
  [[nodiscard]] const std::map<std::string, std::size_t>& reasons() const { return reasons_; }

 private:
  std::size_t planned_ = 0;
  std::size_t checked_ = 0;
  std::size_t check_failed_ = 0;
  std::array<std::size_t, 1001> by_tenths_{};
  std::map<std::string, std::size_t> reasons_;
};

}  // namespace selion
