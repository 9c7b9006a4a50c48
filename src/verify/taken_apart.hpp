// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "check.hpp"

namespace selion::verifying {

/// Holds what a Case refers to. Where frame or job of the file cannot be used, that is found, and the case is
/// not to be checked further.
class TakenApart {
 public:
  explicit TakenApart(const PlanFile& file);
  TakenApart(const TakenApart&) = delete;
  TakenApart& operator=(const TakenApart&) = delete;
  TakenApart(TakenApart&&) = delete;
  TakenApart& operator=(TakenApart&&) = delete;
  ~TakenApart() = default;

  [[nodiscard]] bool usable() const { return usable_; }
  [[nodiscard]] Case& plan() { return case_; }
  [[nodiscard]] std::vector<Finding> findings() && { return std::move(findings_).all(); }

 private:
  void check_frame();
  void check_job(const std::string& trouble);
  void check_trajectories();
  void check_copies();
  void check_trajectory(const TrajectoryRecord& t);
  void refuse(const char* code, const std::string& what);

  Plane plane_;
  Vehicle vehicle_;
  Findings findings_;
  Case case_;
  bool usable_ = true;
};

}  // namespace selion::verifying
