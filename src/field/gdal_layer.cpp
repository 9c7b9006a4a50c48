// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal_layer.hpp"

#include <algorithm>
#include <memory>
#include <type_traits>

#include <ogr_api.h>

#include "gdal_crs.hpp"
#include "gdal_library.hpp"

namespace selion {
namespace {

struct DestroyGeometry {
  void operator()(OGRGeometryH geometry) const { SELION_GDAL(OGR_G_DestroyGeometry)(geometry); }
};
using Geometry = std::unique_ptr<std::remove_pointer_t<OGRGeometryH>, DestroyGeometry>;

struct DestroyFeature {
  void operator()(void* feature) const { SELION_GDAL(OGR_F_Destroy)(feature); }
};

RawPoint point_of(OGRGeometryH geometry, int i, bool swap) {
  const RawPoint p{SELION_GDAL(OGR_G_GetX)(geometry, i), SELION_GDAL(OGR_G_GetY)(geometry, i)};
  return swap ? RawPoint{p.y, p.x} : p;
}

RawRing ring_of(OGRGeometryH line, bool swap) {
  const int count = SELION_GDAL(OGR_G_GetPointCount)(line);
  RawRing ring;
  ring.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) ring.push_back(point_of(line, i, swap));
  return ring;
}

std::vector<OGRGeometryH> parts_of(OGRGeometryH geometry) {
  std::vector<OGRGeometryH> parts;
  for (int i = 0; i < SELION_GDAL(OGR_G_GetGeometryCount)(geometry); ++i)
    parts.push_back(SELION_GDAL(OGR_G_GetGeometryRef)(geometry, i));
  return parts;
}

void collect(OGRGeometryH geometry, bool swap, RawFeature& into) {
  constexpr double kStep_deg = 0.5;  // a chord leaves its arc by 5 mm at a radius of 500 m
  if (SELION_GDAL(OGR_G_IsEmpty)(geometry) != 0) return;
  if (SELION_GDAL(OGR_G_HasCurveGeometry)(geometry, TRUE) != 0) {
    const Geometry linear{SELION_GDAL(OGR_G_GetLinearGeometry)(geometry, kStep_deg, nullptr)};
    if (linear) collect(linear.get(), swap, into);
    return;
  }
  switch (SELION_GDAL(OGR_GT_Flatten)(SELION_GDAL(OGR_G_GetGeometryType)(geometry))) {
    case wkbPolygon:
    case wkbTriangle: {
      RawPolygon polygon;
      for (OGRGeometryH ring : parts_of(geometry)) polygon.push_back(ring_of(ring, swap));
      into.polygons.push_back(std::move(polygon));
      return;
    }
    case wkbLineString:
      into.lines.push_back(ring_of(geometry, swap));
      return;
    case wkbPoint:
      into.points.push_back(point_of(geometry, 0, swap));
      return;
    case wkbMultiPolygon:
    case wkbMultiLineString:
    case wkbMultiPoint:
    case wkbGeometryCollection:
      for (OGRGeometryH part : parts_of(geometry)) collect(part, swap, into);
      return;
    default:
      into.notes.push_back(std::string{"a geometry of type "} + SELION_GDAL(OGR_G_GetGeometryName)(geometry) +
                           " is left out");
  }
}

std::string text_of(OGRFeatureH feature, int i) {
  if (SELION_GDAL(OGR_Fld_GetType)(SELION_GDAL(OGR_F_GetFieldDefnRef)(feature, i)) != OFTStringList)
    return SELION_GDAL(OGR_F_GetFieldAsString)(feature, i);
  std::string joined;
  for (char** one = SELION_GDAL(OGR_F_GetFieldAsStringList)(feature, i); one != nullptr && *one != nullptr;
       ++one)
    joined += (joined.empty() ? "" : "; ") + std::string{*one};
  return joined;
}

void collect_attributes(OGRFeatureH feature, std::span<const std::string_view> skipped, RawFeature& into) {
  for (int i = 0; i < SELION_GDAL(OGR_F_GetFieldCount)(feature); ++i) {
    if (SELION_GDAL(OGR_F_IsFieldSetAndNotNull)(feature, i) == 0) continue;
    const std::string name = SELION_GDAL(OGR_Fld_GetNameRef)(SELION_GDAL(OGR_F_GetFieldDefnRef)(feature, i));
    if (std::find(skipped.begin(), skipped.end(), name) != skipped.end()) continue;
    bool was_latin1 = false;
    const std::string value = as_utf8(text_of(feature, i), was_latin1);
    if (value.empty()) continue;
    if (was_latin1) into.notes.push_back("its attribute '" + name + "' is not UTF-8, and is read as Latin-1");
    into.attributes[name] = value;
    into.attribute_order.push_back(name);
  }
}

}  // namespace

LayerCursor::LayerCursor(void* opened, std::vector<std::string_view> skipped_attributes)
    : layer_{opened},
      skipped_{std::move(skipped_attributes)},
      swap_{northing_first(SELION_GDAL(OGR_L_GetSpatialRef)(static_cast<OGRLayerH>(opened)))} {
  SELION_GDAL(OGR_L_ResetReading)(static_cast<OGRLayerH>(layer_));
}

RawLayer LayerCursor::about() const {
  auto* layer = static_cast<OGRLayerH>(layer_);
  RawLayer raw;
  raw.name = SELION_GDAL(OGR_L_GetName)(layer);
  raw.crs = crs_definition(SELION_GDAL(OGR_L_GetSpatialRef)(layer));
  return raw;
}

RawFeature LayerCursor::raw_of(void* feature, int number) const {
  RawFeature one;
  one.number = number;
  one.id = SELION_GDAL(OGR_F_GetFID)(static_cast<OGRFeatureH>(feature));
  collect_attributes(static_cast<OGRFeatureH>(feature), skipped_, one);
  OGRGeometryH geometry = SELION_GDAL(OGR_F_GetGeometryRef)(static_cast<OGRFeatureH>(feature));
  if (geometry != nullptr) collect(geometry, swap_, one);
  return one;
}

std::optional<RawFeature> LayerCursor::next() {
  const std::unique_ptr<void, DestroyFeature> feature{
      SELION_GDAL(OGR_L_GetNextFeature)(static_cast<OGRLayerH>(layer_))};
  if (!feature) return std::nullopt;
  return raw_of(feature.get(), ++count_);
}

std::optional<RawFeature> LayerCursor::at(std::int64_t id, int number) const {
  const std::unique_ptr<void, DestroyFeature> feature{
      SELION_GDAL(OGR_L_GetFeature)(static_cast<OGRLayerH>(layer_), id)};
  if (!feature) return std::nullopt;
  return raw_of(feature.get(), number);
}

RawLayer read_layer(void* opened, std::span<const std::string_view> skipped_attributes) {
  LayerCursor cursor{opened, {skipped_attributes.begin(), skipped_attributes.end()}};
  RawLayer raw = cursor.about();
  while (auto feature = cursor.next()) raw.features.push_back(std::move(*feature));
  return raw;
}

}  // namespace selion
