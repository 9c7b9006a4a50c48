// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal_crs.hpp"

#include <array>
#include <memory>
#include <string_view>

#include <cpl_conv.h>
#include <ogr_srs_api.h>

#include "gdal_library.hpp"

namespace selion {
namespace {

struct Release {
  void operator()(void* srs) const { SELION_GDAL(OSRRelease)(srs); }
};
struct FreeArray {
  void operator()(OGRSpatialReferenceH* all) const { SELION_GDAL(OSRFreeSRSArray)(all); }
};
struct Free {
  void operator()(void* memory) const { SELION_GDAL(VSIFree)(memory); }
};

std::optional<std::string> code_of(OGRSpatialReferenceH srs) {
  const char* authority = SELION_GDAL(OSRGetAuthorityName)(srs, nullptr);
  const char* number = SELION_GDAL(OSRGetAuthorityCode)(srs, nullptr);
  if (authority == nullptr || number == nullptr) return std::nullopt;
  return std::string{authority} + ":" + number;
}

bool is_epsg(OGRSpatialReferenceH srs) {
  const char* authority = SELION_GDAL(OSRGetAuthorityName)(srs, nullptr);
  return authority != nullptr && std::string_view{authority} == "EPSG";
}

/// The only CRS that GDAL is sure of, or the only one of those that is EPSG's.
std::optional<std::string> best_match(OGRSpatialReferenceH srs) {
  constexpr int kSure = 90;
  int count = 0;
  int* percent = nullptr;
  const std::unique_ptr<OGRSpatialReferenceH, FreeArray> found{
      SELION_GDAL(OSRFindMatches)(srs, nullptr, &count, &percent)};
  const std::unique_ptr<int, Free> kept{percent};
  std::optional<std::string> best;
  for (int i = 0; i < count; ++i) {
    OGRSpatialReferenceH one = found.get()[i];
    if (percent[i] < kSure || (count > 1 && !is_epsg(one))) continue;
    if (best) return std::nullopt;
    best = code_of(one);
  }
  return best;
}

std::string wkt_of(OGRSpatialReferenceH srs) {
  char* wkt = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  SELION_GDAL(OSRExportToWktEx)(srs, &wkt, options.data());
  const std::unique_ptr<char, Free> kept{wkt};
  return wkt == nullptr ? "" : wkt;
}

}  // namespace

std::optional<std::string> crs_definition(void* srs) {
  const char* name = srs == nullptr ? nullptr : SELION_GDAL(OSRGetName)(srs);
  if (name == nullptr) return std::nullopt;
  if (std::string_view{name}.starts_with("Undefined ")) return std::nullopt;  // of GeoPackages
  const std::unique_ptr<void, Release> flat{SELION_GDAL(OSRClone)(srs)};
  SELION_GDAL(OSRStripVertical)(flat.get());
  if (auto own = code_of(flat.get())) return own;
  if (auto match = best_match(flat.get())) return match;
  return wkt_of(flat.get());
}

bool northing_first(void* srs) {
  return srs != nullptr && SELION_GDAL(OSRGetAxisMappingStrategy)(srs) == OAMS_AUTHORITY_COMPLIANT &&
         (SELION_GDAL(OSREPSGTreatsAsLatLong)(srs) != 0 ||
          SELION_GDAL(OSREPSGTreatsAsNorthingEasting)(srs) != 0);
}

}  // namespace selion
