// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_crs.hpp"

#include <memory>

#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "ogr.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

using Handle = std::shared_ptr<void>;

Handle new_system() {
  return {SELION_OGR(OSRNewSpatialReference)(nullptr), SELION_OGR(OSRDestroySpatialReference)};
}

/// The step from `system`, its axes in the order that it has them.
ToWgs84 step_from(const Handle& system) {
  const Handle wgs84 = new_system();
  SELION_OGR(OSRSetWellKnownGeogCS)(wgs84.get(), "WGS84");
  SELION_OGR(OSRSetAxisMappingStrategy)(wgs84.get(), OAMS_TRADITIONAL_GIS_ORDER);
  const Handle step{SELION_OGR(OCTNewCoordinateTransformation)(system.get(), wgs84.get()),
                    SELION_OGR(OCTDestroyCoordinateTransformation)};
  if (!step) throw InputError{"there is no way from the file's coordinate system to WGS84"};
  return [step, transform = SELION_OGR(OCTTransform)](double x, double y) {
    if (transform(step.get(), 1, &x, &y, nullptr) == 0)
      throw InputError{"a corner of the field has no place in WGS84: is the file's coordinate system right?"};
    return LonLat{x, y};
  };
}

}  // namespace

ToWgs84 to_wgs84_of(void* layer) {
  const OGRSpatialReferenceH of_layer = SELION_OGR(OGR_L_GetSpatialRef)(layer);
  if (of_layer == nullptr) return [](double x, double y) { return LonLat{x, y}; };
  return step_from({SELION_OGR(OSRClone)(of_layer), SELION_OGR(OSRDestroySpatialReference)});
}

}  // namespace selion::verifying
