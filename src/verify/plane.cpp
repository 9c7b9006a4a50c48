// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane.hpp"

#include <cmath>
#include <numbers>

#include <proj.h>

namespace selion::verifying {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A projection of WGS84 itself is a formula; anything else is a step between coordinate systems, which takes
/// PROJ milliseconds to set up.
bool is_of_wgs84(const std::string& proj) {
  return proj.find("+datum=WGS84") != std::string::npos && proj.find("+towgs84") == std::string::npos &&
         proj.find("+nadgrids") == std::string::npos && proj.find("+axis") == std::string::npos &&
         proj.find("+type=crs") == std::string::npos;
}

}  // namespace

Plane::Plane() : context_{proj_context_create(), proj_context_destroy} {
  proj_log_level(context_.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context_.get(), 0);
}

Plane Plane::of_code(const std::string& code) {
  Plane plane;
  const std::unique_ptr<PJconsts, decltype(&proj_destroy)> raw{
      proj_create_crs_to_crs(plane.context_.get(), "OGC:CRS84", code.c_str(), nullptr), proj_destroy};
  PJ* east_first = raw ? proj_normalize_for_visualization(plane.context_.get(), raw.get()) : nullptr;
  if (east_first != nullptr) plane.transform_ = {east_first, proj_destroy};
  return plane;
}

Plane::Plane(const std::string& proj) : Plane{} {
  in_radians_ = is_of_wgs84(proj);
  PJ* made = in_radians_ ? proj_create(context_.get(), proj.c_str())
                         : proj_create_crs_to_crs(context_.get(), "OGC:CRS84", (proj + " +type=crs").c_str(),
                                                  nullptr);
  if (made != nullptr) transform_ = {made, proj_destroy};
}

Point Plane::to_local(LonLat p) const {
  const double unit = in_radians_ ? kDegree : 1;
  const PJ_COORD out =
      proj_trans(transform_.get(), PJ_FWD, proj_coord(unit * p.lon_deg, unit * p.lat_deg, 0, HUGE_VAL));
  return std::isfinite(out.xy.x) && std::isfinite(out.xy.y) ? Point{out.xy.x, out.xy.y} : Point{NAN, NAN};
}

LonLat Plane::to_lonlat(Point p) const {
  const double unit = in_radians_ ? kDegree : 1;
  const PJ_COORD out = proj_trans(transform_.get(), PJ_INV, proj_coord(p.x_m, p.y_m, 0, HUGE_VAL));
  return {out.xy.x / unit, out.xy.y / unit};
}

Point ground_m(LonLat from, LonLat to) {
  constexpr double kMajor_m = 6378137;
  constexpr double kEccentricity2 = 0.00669437999014;
  const double lat = (from.lat_deg + to.lat_deg) / 2 * kDegree;
  const double flat = 1 - kEccentricity2 * std::sin(lat) * std::sin(lat);
  const double across_m = kMajor_m / std::sqrt(flat);             // radius of curvature, prime vertical
  const double along_m = across_m * (1 - kEccentricity2) / flat;  // of the meridian
  const double east_deg = std::remainder(to.lon_deg - from.lon_deg, 360);  // across the date line too
  return {east_deg * kDegree * across_m * std::cos(lat), (to.lat_deg - from.lat_deg) * kDegree * along_m};
}

std::vector<Point> Plane::to_local(const std::vector<LonLat>& line) const {
  std::vector<Point> local;
  local.reserve(line.size());
  for (const LonLat p : line) local.push_back(to_local(p));
  return local;
}

}  // namespace selion::verifying
