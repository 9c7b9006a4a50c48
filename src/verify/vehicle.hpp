// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "selion/core/machine.hpp"

namespace selion::verifying {

/// What a job says of swaths and headland.
struct Work {
  double overlap_m = 0;
  double ab_shift_m = 0;
  std::vector<double> ab;               ///< longitude, latitude of A, then of B; or empty
  std::optional<double> direction_deg;  ///< of the compass, where one was asked for
  bool by_p3 = false;                   ///< by the rule of Cariou et al. 2020
  std::optional<double> passes;         ///< of the headland, where a number was asked for
  std::string headland_order;           ///< first | last | none
  std::string start;                    ///< "gate:1", a gate's name, or empty
};

/// What a job says of the machine and of the distances that it keeps.
struct Vehicle {
  Machine machine;
  Work work;
  std::string frame_crs;  ///< auto, or a code
  double edge_margin_m = 0;
  double obstacle_clearance_m = 0;
  double water_margin_m = 0;
  double most_curvature_per_m = 0;          ///< by steering angle or turning radius
  double most_working_curvature_per_m = 0;  ///< with the tool down
  double most_steering_rad_s = 0;
};

/// @returns the keys that are missing, or have values that this version does not plan with, in `trouble`;
/// then the vehicle is not to be used.
Vehicle vehicle_of(const std::string& job_json, std::string& trouble);

/// Half the width of tool or body, whichever is wider.
double half_tool_m(const Vehicle& vehicle);
/// From one headland pass to the next: no sliver stays between them.
double ring_spacing_m(const Vehicle& vehicle);

/// How fast the steering moves (its angle is atan(L k); of a differential machine, L k itself) where a path
/// of that curvature and sharpness is driven at that speed.
double steering_rad_s(const Vehicle& vehicle, double curvature_per_m, double sharpness_per_m2,
                      double speed_mps);

}  // namespace selion::verifying
