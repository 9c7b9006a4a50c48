// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/field/geopackage.hpp"

#include <array>
#include <type_traits>
#include <utility>

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "gdal_handles.hpp"
#include "gdal_library.hpp"
#include "selion/core/error.hpp"

namespace selion {
namespace {

struct Release {
  void operator()(void* srs) const { SELION_GDAL(OSRRelease)(srs); }
};
struct DestroyFeature {
  void operator()(void* feature) const { SELION_GDAL(OGR_F_Destroy)(feature); }
};
struct DestroyGeometry {
  void operator()(OGRGeometryH geometry) const { SELION_GDAL(OGR_G_DestroyGeometry)(geometry); }
};
using Geometry = std::unique_ptr<std::remove_pointer_t<OGRGeometryH>, DestroyGeometry>;

/// The same bytes whatever the day and the environment's settings are.
struct SameBytes {
  static constexpr std::array<std::array<const char*, 2>, 3> kSettings{
      {{"OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"},
       {"OGR_SQLITE_JOURNAL", "DELETE"},
       {"OGR_SQLITE_PRAGMA", ""}}};

  SameBytes() {
    for (const auto& [name, value] : kSettings) SELION_GDAL(CPLSetThreadLocalConfigOption)(name, value);
  }
  SameBytes(const SameBytes&) = delete;
  SameBytes(SameBytes&&) = delete;
  SameBytes& operator=(const SameBytes&) = delete;
  SameBytes& operator=(SameBytes&&) = delete;
  ~SameBytes() {
    for (const auto& setting : kSettings) SELION_GDAL(CPLSetThreadLocalConfigOption)(setting[0], nullptr);
  }
};

OGRFieldType type_of(ColumnType type) {
  switch (type) {
    case ColumnType::whole:
      return OFTInteger64;
    case ColumnType::real:
      return OFTReal;
    case ColumnType::text:
      break;
  }
  return OFTString;
}

void add_ring(OGRGeometryH polygon, const LonLatRing& ring) {
  OGRGeometryH line = SELION_GDAL(OGR_G_CreateGeometry)(wkbLinearRing);
  for (const LonLat p : ring) SELION_GDAL(OGR_G_AddPoint_2D)(line, p.lon_deg, p.lat_deg);
  SELION_GDAL(OGR_G_AddPoint_2D)(line, ring.front().lon_deg, ring.front().lat_deg);
  SELION_GDAL(OGR_G_AddGeometryDirectly)(polygon, line);
}

Geometry geometry_of(const std::vector<LonLatPolygon>& area) {
  Geometry all{SELION_GDAL(OGR_G_CreateGeometry)(wkbMultiPolygon)};
  for (const LonLatPolygon& part : area) {
    OGRGeometryH polygon = SELION_GDAL(OGR_G_CreateGeometry)(wkbPolygon);
    add_ring(polygon, part.shell);
    for (const LonLatRing& hole : part.holes) add_ring(polygon, hole);
    SELION_GDAL(OGR_G_AddGeometryDirectly)(all.get(), polygon);
  }
  return all;
}

void set_cell(void* feature, int column, const TableCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell))
    SELION_GDAL(OGR_F_SetFieldString)(feature, column, text->c_str());
  else if (const auto* whole = std::get_if<long long>(&cell))
    SELION_GDAL(OGR_F_SetFieldInteger64)(feature, column, *whole);
  else if (const auto* real = std::get_if<double>(&cell))
    SELION_GDAL(OGR_F_SetFieldDouble)(feature, column, *real);
}

}  // namespace

struct GeoPackageTable::State {
  std::string file;
  void* dataset = nullptr;
  OGRLayerH layer = nullptr;

  void must(bool right, const GdalMessages& messages) const {
    if (right && messages.failures.empty()) return;
    throw InputError{file + " cannot be written" +
                     (messages.failures.empty() ? "" : ": " + messages.failures.front())};
  }
};

GeoPackageTable::GeoPackageTable(const std::filesystem::path& file, const std::string& layer,
                                 const std::vector<TableColumn>& columns)
    : state_{std::make_unique<State>()} {
  const GdalMessages messages;
  const SameBytes same_bytes;
  State& state = *state_;
  state.file = file.string();
  SELION_GDAL(GDALAllRegister)();
  GDALDriverH driver = SELION_GDAL(GDALGetDriverByName)("GPKG");
  state.must(driver != nullptr, messages);
  state.dataset = SELION_GDAL(GDALCreate)(driver, state.file.c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  state.must(state.dataset != nullptr, messages);
  const std::unique_ptr<void, Release> wgs84{SELION_GDAL(OSRNewSpatialReference)(nullptr)};
  state.must(SELION_GDAL(OSRImportFromEPSG)(wgs84.get(), 4326) == OGRERR_NONE, messages);
  SELION_GDAL(OSRSetAxisMappingStrategy)(wgs84.get(), OAMS_TRADITIONAL_GIS_ORDER);
  state.layer = SELION_GDAL(GDALDatasetCreateLayer)(state.dataset, layer.c_str(), wgs84.get(),
                                                    wkbMultiPolygon, nullptr);
  state.must(state.layer != nullptr, messages);
  for (const TableColumn& column : columns) {
    OGRFieldDefnH definition = SELION_GDAL(OGR_Fld_Create)(column.name.c_str(), type_of(column.type));
    SELION_GDAL(OGR_L_CreateField)(state.layer, definition, TRUE);
    SELION_GDAL(OGR_Fld_Destroy)(definition);
  }
  SELION_GDAL(GDALDatasetStartTransaction)(state.dataset, FALSE);
  state.must(true, messages);
}

GeoPackageTable::~GeoPackageTable() {
  if (state_->dataset == nullptr) return;
  const GdalMessages silence;  // what went wrong was said before
  SELION_GDAL(GDALClose)(state_->dataset);
}

void GeoPackageTable::add(long long id, const std::vector<TableCell>& cells,
                          const std::vector<LonLatPolygon>& area) {
  const GdalMessages messages;
  const SameBytes same_bytes;
  const std::unique_ptr<void, DestroyFeature> feature{
      SELION_GDAL(OGR_F_Create)(SELION_GDAL(OGR_L_GetLayerDefn)(state_->layer))};
  SELION_GDAL(OGR_F_SetFID)(feature.get(), id);
  for (std::size_t i = 0; i < cells.size(); ++i) set_cell(feature.get(), static_cast<int>(i), cells[i]);
  if (!area.empty()) SELION_GDAL(OGR_F_SetGeometryDirectly)(feature.get(), geometry_of(area).release());
  state_->must(SELION_GDAL(OGR_L_CreateFeature)(state_->layer, feature.get()) == OGRERR_NONE, messages);
}

void GeoPackageTable::close() {
  const GdalMessages messages;
  const SameBytes same_bytes;
  SELION_GDAL(GDALDatasetCommitTransaction)(state_->dataset);
  SELION_GDAL(GDALClose)(std::exchange(state_->dataset, nullptr));
  state_->must(true, messages);
}

}  // namespace selion
