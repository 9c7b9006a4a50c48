// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "selion/motion/footprint.hpp"
#include "selion/motion/turns.hpp"

namespace selion {

/// How a headland pass goes from one of its lines to the next: clothoid, arc, clothoid, where a clothoid may
/// be eased: then the curvature dies away like exp(-s / ease_m), in straight steps. A body whose front (on
/// the way in: whose rear) corner slides along the lane's edge draws such a curve with its axle (a tractrix,
/// whose length scale is the corner's reach), so this is the shortest corner at which it does not swing out.
struct CornerShape {
  CurveLimits limits;
  double ease_in_m = 0;  ///< 0: a clothoid of the limit's sharpness
  double ease_out_m = 0;
};

/// A turn by `turn_rad` (left positive) that starts straight at `start` and ends straight.
Path corner_path(const Pose& start, double turn_rad, const CornerShape& shape);

/// Where a corner begins before the point in which its two lines meet, and where it ends after it; and how
/// far it passes from that point.
struct CornerReach {
  double before_m = 0;
  double after_m = 0;
  double cut_m = 0;
};
CornerReach reach_of(double turn_rad, const CornerShape& shape);

/// The quickest shape of a left turn for which body and tool swing out of the lane, to its right, by no more
/// than `room_m`: eased only as far as that takes.
CornerShape shape_within(double turn_rad, const CurveLimits& limits, const Footprint& footprint,
                         double room_m);

}  // namespace selion
