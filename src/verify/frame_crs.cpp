// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_crs.hpp"

#include <array>
#include <cmath>

namespace selion::verifying {
namespace {

// A kilometre from the origin, in degrees, to the sides.
constexpr double kStep_deg = 0.01;
constexpr double kScale = 2e-6;   // of a frame that is true to scale, out there
constexpr double kSame_m = 0.05;  // over 2 km: ties of datums differ by as much

/// Ways between places around the origin.
std::array<Point, 2> across(const Plane& plane, LonLat at) {
  const auto place = [&](double east, double north) {
    return plane.to_local({at.lon_deg + east * kStep_deg, at.lat_deg + north * kStep_deg});
  };
  return {place(1, 0) - place(-1, 0), place(0, 1) - place(0, -1)};
}

/// North is up at the origin, and a degree as long as on the ground.
bool is_centred(const Plane& plane, LonLat origin) {
  const auto [east, north] = across(plane, origin);
  constexpr double kSmall_deg = 1e-3;
  const LonLat south{origin.lon_deg, origin.lat_deg - kSmall_deg / 2};
  const LonLat above{origin.lon_deg, origin.lat_deg + kSmall_deg / 2};
  const double ground = length_m(ground_m(south, above));
  const double told = length_m(plane.to_local(above) - plane.to_local(south));
  return std::abs(told / ground - 1) <= kScale && std::abs(north.x_m) <= kSame_m &&
         std::abs(east.y_m) <= kSame_m;
}

bool is_code(const std::string& crs) {
  const std::size_t colon = crs.find(':');
  return colon != std::string::npos && colon > 0 && colon + 1 < crs.size() &&
         crs.find_first_of(" +/\\") == std::string::npos;
}

}  // namespace

bool is_frame_of(const Plane& plane, LonLat origin, const std::string& crs) {
  if (crs == "auto") return is_centred(plane, origin);
  if (!is_code(crs)) return false;
  const Plane coded = Plane::of_code(crs);
  if (!coded.valid()) return false;
  const auto own = across(plane, origin);
  const auto told = across(coded, origin);
  return distance_m(own[0], told[0]) <= kSame_m && distance_m(own[1], told[1]) <= kSame_m;
}

}  // namespace selion::verifying
