// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "records.hpp"
#include "selion/core/error.hpp"
#include "selion/core/progress.hpp"
#include "selion/plan/job.hpp"

namespace selion {

/// False where there is no plan `a`, true where there is no other.
bool covers_more(const Result<PlannedBlock>& a, const Result<PlannedBlock>& b);

/// Tries layouts of one block, each with what those before have found out about its ground.
class BlockPlanner {
 public:
  BlockPlanner(const Block& block, const LocalFrame& frame, const Progress& progress);

  /// With corners filled, as the job says, where that covers more: what it takes to fill them may be in the
  /// way of other work.
  /// @param border_room_m the outermost passes keep so much further off the border
  [[nodiscard]] Result<PlannedBlock> planned(const Job& job, double border_room_m = 0);

 private:
  struct Attempt {
    Interior interior = Interior::swaths;
    double beyond_m2 = 0;  ///< not driven where it can hardly cover more
  };

  [[nodiscard]] Result<Layout> laid_out(const Job& job, Interior interior) const;
  [[nodiscard]] RouteOptions route_options(const Job& job) const;
  [[nodiscard]] Result<PlannedBlock> as_told(const Job& job, const Attempt& attempt) const;
  [[nodiscard]] Result<PlannedBlock> with_headland(const Job& job) const;
  [[nodiscard]] bool is_narrow(const Job& job) const;
  [[nodiscard]] bool is_closed_band(const Job& job) const;
  [[nodiscard]] Result<PlannedBlock> inside_fewer(const Infeasible& refused, const Job& job) const;
  [[nodiscard]] Result<PlannedBlock> with_fewer_passes(Job job, int needed, Result<PlannedBlock> best) const;
  [[nodiscard]] Result<PlannedBlock> or_along_borders(Result<PlannedBlock> best, const Job& job) const;
  [[nodiscard]] Result<PlannedBlock> with_passes_alone(const Job& job, double beyond_m2) const;

  const Block& block_;
  const LocalFrame& frame_;
  const Progress& progress_;
  std::shared_ptr<KnownGround> known_;
  double border_room_m_ = 0;
};

}  // namespace selion
