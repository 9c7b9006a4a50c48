// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_crs.hpp"

#include <array>
#include <cmath>
#include <memory>

#include <ogr_srs_api.h>
#include <proj.h>

#include "findings.hpp"
#include "ogr.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

using System = std::shared_ptr<void>;

/// By PROJ, for OGR would open files and addresses of that name too.
System system_named(const std::string& name) {
  const std::unique_ptr<PJ_CONTEXT, decltype(&proj_context_destroy)> context{proj_context_create(),
                                                                             proj_context_destroy};
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context.get(), 0);
  const std::unique_ptr<PJ, decltype(&proj_destroy)> crs{proj_create(context.get(), name.c_str()),
                                                         proj_destroy};
  const char* wkt = crs && proj_is_crs(crs.get()) != 0
                        ? proj_as_wkt(context.get(), crs.get(), PJ_WKT2_2019, nullptr)
                        : nullptr;
  if (wkt == nullptr) throw InputError{"--crs " + name + ": PROJ knows no such coordinate system"};
  System system{SELION_OGR(OSRNewSpatialReference)(wkt), SELION_OGR(OSRDestroySpatialReference)};
  SELION_OGR(OSRSetAxisMappingStrategy)(system.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

bool are_same(const System& a, const System& b) {
  constexpr std::array<const char*, 3> kHow{"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                            "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr};
  return SELION_OGR(OSRIsSameEx)(a.get(), b.get(), kHow.data()) != 0;
}

/// GeoPackages have one for coordinates of which nothing is known.
bool is_undefined(void* system) {
  const char* name = SELION_OGR(OSRGetName)(system);
  return name == nullptr || std::string{name}.starts_with("Undefined ");
}

/// Of a layer of OGR its axes are in the order that OGR has them.
System system_of(const OwnerCrs& crs) {
  if (crs.of_layer == nullptr || is_undefined(crs.of_layer)) {
    if (!crs.option && !crs.usual)
      throw InputError{crs.where + " has no coordinate system; name it with --crs, such as --crs EPSG:25832"};
    return system_named(crs.option ? *crs.option : *crs.usual);
  }
  System own{SELION_OGR(OSRClone)(crs.of_layer), SELION_OGR(OSRDestroySpatialReference)};
  if (crs.option && !are_same(own, system_named(*crs.option)))
    throw InputError{crs.where + " is in " + SELION_OGR(OSRGetName)(own.get()) + ", but --crs says " +
                     *crs.option + "; leave --crs out, or correct the file"};
  return own;
}

LonLat checked(LonLat p, const std::string& where) {
  if (std::abs(p.lon_deg) <= 360 && std::abs(p.lat_deg) <= 90) return p;
  throw InputError{where + ": " + shown(p.lon_deg, 4) + ", " + shown(p.lat_deg, 4) +
                   " is no longitude and latitude; name the coordinate system with --crs"};
}

/// To WGS84, its axes in the order of `system`.
class Step {
 public:
  explicit Step(const OwnerCrs& crs)
      : where_{crs.where},
        step_{
            SELION_OGR(OCTNewCoordinateTransformation)(system_of(crs).get(), system_named("OGC:CRS84").get()),
            SELION_OGR(OCTDestroyCoordinateTransformation)},
        transform_{SELION_OGR(OCTTransform)} {
    if (!step_) throw InputError{where_ + ": there is no way from its coordinate system to WGS84"};
  }

  [[nodiscard]] LonLat place(double x, double y) const {
    if (transform_(step_.get(), 1, &x, &y, nullptr) != 0) return checked({x, y}, where_);
    throw InputError{where_ + ": a corner has no place in WGS84; is its coordinate system right?"};
  }

 private:
  std::string where_;
  std::shared_ptr<void> step_;
  decltype(&::OCTTransform) transform_;
};

}  // namespace

ToWgs84 as_they_are(const std::string& where) {
  return [where](double lon_deg, double lat_deg) { return checked({lon_deg, lat_deg}, where); };
}

ToWgs84 to_wgs84_of(const OwnerCrs& crs) {
  return [crs, step = std::optional<Step>{}](double x, double y) mutable {
    if (!step) step.emplace(crs);
    return step->place(x, y);
  };
}

}  // namespace selion::verifying
