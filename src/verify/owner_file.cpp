// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string_view>

#include <dlfcn.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

/// A function of GDAL's library, which is loaded when the first file needs it: it takes longer than a plan.
void* symbol(const char* name) {
  static void* const library = ::dlopen(SELION_GDAL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  void* found = library == nullptr ? nullptr : ::dlsym(library, name);
  if (found == nullptr)
    throw InputError{"reading this field needs GDAL (" SELION_GDAL_LIBRARY "), which is not installed here"};
  return found;
}
#define SELION_OGR(name) (reinterpret_cast<decltype(&::name)>(symbol(#name)))

LonLatLine ring_of(OGRGeometryH ring, OGRCoordinateTransformationH to_wgs84) {
  LonLatLine line;
  const auto x = SELION_OGR(OGR_G_GetX);
  const auto y = SELION_OGR(OGR_G_GetY);
  const auto transform = SELION_OGR(OCTTransform);
  for (int i = 0; i < SELION_OGR(OGR_G_GetPointCount)(ring); ++i) {
    double lon = x(ring, i);
    double lat = y(ring, i);
    if (to_wgs84 != nullptr && transform(to_wgs84, 1, &lon, &lat, nullptr) == 0)
      throw InputError{"a corner of the field has no place in WGS84: is the file's coordinate system right?"};
    line.push_back({lon, lat});
  }
  if (line.size() > 1 && line.front() == line.back()) line.pop_back();
  return line;
}

LonLatArea area_of(OGRGeometryH polygon, OGRCoordinateTransformationH to_wgs84) {
  LonLatArea area;
  for (int i = 0; i < SELION_OGR(OGR_G_GetGeometryCount)(polygon); ++i) {
    LonLatLine ring = ring_of(SELION_OGR(OGR_G_GetGeometryRef)(polygon, i), to_wgs84);
    if (ring.size() < 3) continue;
    if (i == 0)
      area.shell = std::move(ring);
    else
      area.holes.push_back(std::move(ring));
  }
  return area;
}

void add_parts(OwnerFeature& feature, OGRGeometryH geometry, OGRCoordinateTransformationH to_wgs84) {
  if (geometry == nullptr) return;
  const OGRwkbGeometryType type = SELION_OGR(OGR_GT_Flatten)(SELION_OGR(OGR_G_GetGeometryType)(geometry));
  if (type == wkbPolygon) {
    LonLatArea area = area_of(geometry, to_wgs84);
    if (!area.shell.empty()) feature.parts.push_back(std::move(area));
  } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
    for (int i = 0; i < SELION_OGR(OGR_G_GetGeometryCount)(geometry); ++i)
      add_parts(feature, SELION_OGR(OGR_G_GetGeometryRef)(geometry, i), to_wgs84);
  }
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The attribute of that name, in any case; empty where there is none.
std::string attribute(OGRFeatureH feature, std::string_view name) {
  for (int i = 0; i < SELION_OGR(OGR_F_GetFieldCount)(feature); ++i) {
    const OGRFieldDefnH field = SELION_OGR(OGR_F_GetFieldDefnRef)(feature, i);
    if (lower(SELION_OGR(OGR_Fld_GetNameRef)(field)) == name &&
        SELION_OGR(OGR_F_IsFieldSetAndNotNull)(feature, i) != 0)
      return SELION_OGR(OGR_F_GetFieldAsString)(feature, i);
  }
  return {};
}

std::string name_of(OGRFeatureH feature) {
  for (const std::string_view name :
       {"name", "field", "field_name", "fieldname", "title", "label", "id", "uid", "fid"})
    if (std::string found = attribute(feature, name); !found.empty()) return found;
  return {};
}

/// Of a word of docs/input.md, however it is written; absent of any other.
std::optional<OwnerRole> role_named(const std::string& word) {
  std::string name = lower(word);
  std::ranges::replace_if(
      name, [](char c) { return c == '-' || c == ' '; }, '_');
  if (name == "water") return OwnerRole::water;
  if (name == "gate" || name == "gates") return OwnerRole::gate;
  constexpr std::array<std::string_view, 4> kObstacles{"obstacle", "obstacles", "no_go", "nogo"};
  if (std::ranges::find(kObstacles, name) != kObstacles.end()) return OwnerRole::obstacle;
  return std::nullopt;
}

/// @throws InputError where its attribute `selion` says nothing that is known.
std::optional<OwnerRole> own_role(OGRFeatureH feature, const std::string& where) {
  const std::string word = attribute(feature, "selion");
  if (word.empty()) return std::nullopt;
  if (lower(word) == "field") return OwnerRole::field;
  if (const auto role = role_named(word)) return role;
  throw InputError{where + ": its property selion is '" + word +
                   "', but must be field, obstacle, gate, no_go or water"};
}

using Transformation = std::unique_ptr<void, void (*)(void*)>;

/// From the layer's system to WGS84; null where it is that already, or the layer does not say.
Transformation to_wgs84(OGRLayerH layer) {
  const auto destroy = SELION_OGR(OCTDestroyCoordinateTransformation);
  const OGRSpatialReferenceH of_layer = SELION_OGR(OGR_L_GetSpatialRef)(layer);
  if (of_layer == nullptr) return {nullptr, destroy};
  const auto order = SELION_OGR(OSRSetAxisMappingStrategy);
  const std::unique_ptr<void, void (*)(void*)> from{SELION_OGR(OSRClone)(of_layer),
                                                    SELION_OGR(OSRDestroySpatialReference)};
  const std::unique_ptr<void, void (*)(void*)> wgs84{SELION_OGR(OSRNewSpatialReference)(nullptr),
                                                     SELION_OGR(OSRDestroySpatialReference)};
  SELION_OGR(OSRSetWellKnownGeogCS)(wgs84.get(), "WGS84");
  order(from.get(), OAMS_TRADITIONAL_GIS_ORDER);
  order(wgs84.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return {SELION_OGR(OCTNewCoordinateTransformation)(from.get(), wgs84.get()), destroy};
}

void add_layer(std::vector<OwnerFeature>& features, OGRLayerH layer, OwnerRole usual,
               const std::string& where) {
  const Transformation transformation = to_wgs84(layer);
  const auto next = SELION_OGR(OGR_L_GetNextFeature);
  const auto destroy = SELION_OGR(OGR_F_Destroy);
  long long number = 0;
  SELION_OGR(OGR_L_ResetReading)(layer);
  while (OGRFeatureH raw = next(layer)) {
    const std::unique_ptr<void, void (*)(void*)> held{raw, destroy};
    ++number;
    const std::string here = where + ", feature " + std::to_string(number);
    OwnerFeature feature{name_of(raw), own_role(raw, here).value_or(usual), number, {}};
    OGRGeometryH geometry = SELION_OGR(OGR_F_GetGeometryRef)(raw);
    const std::unique_ptr<void, void (*)(void*)> straight{
        geometry == nullptr ? nullptr : SELION_OGR(OGR_G_GetLinearGeometry)(geometry, 0.5, nullptr),
        SELION_OGR(OGR_G_DestroyGeometry)};
    add_parts(feature, straight.get(), transformation.get());
    if (!feature.parts.empty()) features.push_back(std::move(feature));
  }
}

}  // namespace

std::vector<OwnerFeature> read_owner_file(const GivenField& given) {
  SELION_OGR(GDALAllRegister)();
  const std::string file = given.file.string();
  const std::string opened = lower(given.file.extension().string()) == ".zip" ? "/vsizip/" + file : file;
  const std::unique_ptr<void, void (*)(void*)> data{
      SELION_OGR(GDALOpenEx)(opened.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr),
      [](void* open) {
        if (open != nullptr) SELION_OGR(GDALClose)(open);
      }};
  if (!data) throw InputError{file + ": OGR cannot read it; give the field as a vector file with polygons"};
  std::vector<OwnerFeature> features;
  const std::string where = file + ", layer ";
  const int layers = SELION_OGR(GDALDatasetGetLayerCount)(data.get());
  for (int i = 0; i < layers; ++i) {
    OGRLayerH layer = SELION_OGR(GDALDatasetGetLayer)(data.get(), i);
    const std::string name = SELION_OGR(OGR_L_GetName)(layer);
    const bool wanted = given.layer == name;
    // One that is alone or asked for holds fields whatever it is called.
    const auto role = wanted || layers == 1 ? std::nullopt : role_named(name);
    if (wanted || role || !given.layer)
      add_layer(features, layer, role.value_or(OwnerRole::field), where + name);
  }
  if (std::ranges::count(features, OwnerRole::field, &OwnerFeature::role) == 0)
    throw InputError{file + ": there is no polygon in it" + (given.layer ? " in layer " + *given.layer : "")};
  return features;
}

}  // namespace selion::verifying
