// SPDX-License-Identifier: GPL-3.0-or-later
// A geometry as GeoPackage and the like store it, through the reader of GDAL's layers.
#include <limits>
#include <memory>

#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "field/gdal_handles.hpp"
#include "field/gdal_layer.hpp"
#include "field/gdal_library.hpp"
#include "reading.hpp"
#include "selion/core/error.hpp"

using namespace selion;

namespace {

struct Close {
  void operator()(void* dataset) const { SELION_GDAL(GDALClose)(dataset); }
};
using Dataset = std::unique_ptr<void, Close>;

/// A layer in memory with one feature of this geometry; null where GDAL takes the bytes for none.
void* layer_with(const Dataset& dataset, const std::uint8_t* data, std::size_t size) {
  OGRGeometryH geometry = nullptr;
  const OGRErr error = SELION_GDAL(OGR_G_CreateFromWkb)(data, nullptr, &geometry, static_cast<int>(size));
  if (error != OGRERR_NONE || geometry == nullptr) return nullptr;
  OGRLayerH layer =
      SELION_GDAL(GDALDatasetCreateLayer)(dataset.get(), "fields", nullptr, wkbUnknown, nullptr);
  OGRFeatureH feature = SELION_GDAL(OGR_F_Create)(SELION_GDAL(OGR_L_GetLayerDefn)(layer));
  SELION_GDAL(OGR_F_SetGeometryDirectly)(feature, geometry);
  SELION_GDAL(OGR_L_CreateFeature)(layer, feature);
  SELION_GDAL(OGR_F_Destroy)(feature);
  return layer;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return 0;
  static const bool registered = (SELION_GDAL(GDALAllRegister)(), true);
  static_cast<void>(registered);
  const GdalMessages silence;
  const Dataset dataset{SELION_GDAL(GDALCreate)(SELION_GDAL(GDALGetDriverByName)("Memory"), "fuzz", 0, 0, 0,
                                                GDT_Unknown, nullptr)};
  if (void* layer = layer_with(dataset, data, size)) {
    RawFile file;
    file.layers.push_back(read_layer(layer, {}));
    fuzz::locate_and_clean(file);
  }
  return 0;
}
