// SPDX-License-Identifier: GPL-3.0-or-later
#include "layout_options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "selion/core/error.hpp"
#include "selion/core/units.hpp"
#include "selion/geometry/simplify.hpp"

namespace selion {
namespace {

/// A compass heading in the local frame, whose north leans by the convergence, and which may keep no angles.
double local_heading_rad(const LocalFrame& frame, Point at, double bearing_deg) {
  constexpr int kSteps = 3;  // each leaves a thousandth of the error and less
  double heading = radians_of_degrees(90 - bearing_deg + frame.convergence_deg(at));
  for (int i = 0; i < kSteps; ++i)
    heading += radians_of_degrees(std::remainder(frame.bearing_deg(at, unit(heading)) - bearing_deg, 360));
  return heading;
}

/// Sets direction and heading as `layout.direction` says.
std::optional<Infeasible> choose_direction(LayoutOptions& options, const Block& block,
                                           const LocalFrame& frame, const Job& job) {
  const std::string& how = job.layout.direction;
  if (how == "edge") {
    // steps and wiggles smaller than half the working width cost no swath piece: they must not choose
    options.along = best_edge_direction(simplified(block.area, job.machine.working_width_m / 2));
  } else if (how == "p3") {
    const auto found = p3_direction(block.area);
    if (!found) return found.error();
    options.along = found->along;
  } else {
    double bearing = 0;
    std::from_chars(how.data(), how.data() + how.size(), bearing);  // the job was validated
    options.heading_rad = local_heading_rad(frame, centroid(block.area), bearing);
    options.along = DrivingDirection::radians(*options.heading_rad);
  }
  return std::nullopt;
}

/// @throws InputError where the line lies nowhere near the block.
AbLine ab_line_of(const Block& block, const LocalFrame& frame, const std::array<double, 4>& given) {
  constexpr double kFar_m = 10'000;
  const auto& [lon_a, lat_a, lon_b, lat_b] = given;
  const AbLine ab{frame.to_local({lon_a, lat_a}), frame.to_local({lon_b, lat_b})};
  const double far_m =
      std::min(distance_m(ab.a, centroid(block.area)), distance_m(ab.b, centroid(block.area)));
  if (!(far_m < kFar_m))
    throw InputError{
        "layout.ab lies more than 10 km from the field: give A and B as lon,lat,lon,lat; are "
        "longitude and latitude swapped?"};
  return ab;
}

}  // namespace

Result<LayoutOptions> layout_options(const Block& block, const LocalFrame& frame, const Job& job) {
  LayoutOptions options;
  options.ab_shift_m = job.layout.ab_shift_m;
  options.overlap_m = job.layout.overlap_m;
  options.edge_margin_m = job.field.edge_margin_m;
  options.passes = job.headland.passes;
  options.corners = job.headland.corners;
  if (job.layout.ab) {
    options.ab = ab_line_of(block, frame, *job.layout.ab);
    return options;
  }
  if (const auto why = choose_direction(options, block, frame, job)) return *why;
  return options;
}

}  // namespace selion
