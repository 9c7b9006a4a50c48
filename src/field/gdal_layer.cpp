// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal_layer.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <cpl_conv.h>
#include <ogrsf_frmts.h>

namespace selion {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;

RawRing ring_of(const OGRLineString& line, bool swap) {
  RawRing ring;
  ring.reserve(static_cast<std::size_t>(line.getNumPoints()));
  for (int i = 0; i < line.getNumPoints(); ++i) {
    const RawPoint p{line.getX(i), line.getY(i)};
    ring.push_back(swap ? RawPoint{p.y, p.x} : p);
  }
  return ring;
}

void collect(const OGRGeometry& geometry, bool swap, RawFeature& into) {
  constexpr double kStep_deg = 0.5;  // a chord leaves its arc by 5 mm at a radius of 500 m
  if (geometry.IsEmpty() != 0) return;
  if (geometry.hasCurveGeometry(TRUE) != 0) {
    const Geometry linear{geometry.getLinearGeometry(kStep_deg, nullptr)};
    if (linear) collect(*linear, swap, into);
    return;
  }
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
    case wkbTriangle: {
      RawPolygon polygon;
      for (const auto* ring : *geometry.toPolygon()) polygon.push_back(ring_of(*ring, swap));
      into.polygons.push_back(std::move(polygon));
      return;
    }
    case wkbLineString:
      into.lines.push_back(ring_of(*geometry.toLineString(), swap));
      return;
    case wkbPoint: {
      const RawPoint p{geometry.toPoint()->getX(), geometry.toPoint()->getY()};
      into.points.push_back(swap ? RawPoint{p.y, p.x} : p);
      return;
    }
    case wkbMultiPolygon:
    case wkbMultiLineString:
    case wkbMultiPoint:
    case wkbGeometryCollection:
      for (const auto* part : *geometry.toGeometryCollection()) collect(*part, swap, into);
      return;
    default:
      into.notes.push_back(std::string{"a geometry of type "} + geometry.getGeometryName() + " is left out");
  }
}

std::string text_of(const OGRFeature& feature, int i) {
  if (feature.GetFieldDefnRef(i)->GetType() != OFTStringList) return feature.GetFieldAsString(i);
  std::string joined;
  for (char** one = feature.GetFieldAsStringList(i); one != nullptr && *one != nullptr; ++one)
    joined += (joined.empty() ? "" : "; ") + std::string{*one};
  return joined;
}

void collect_attributes(const OGRFeature& feature, std::span<const std::string_view> skipped,
                        RawFeature& into) {
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    if (!feature.IsFieldSetAndNotNull(i)) continue;
    const std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
    if (std::find(skipped.begin(), skipped.end(), name) != skipped.end()) continue;
    bool was_latin1 = false;
    const std::string value = as_utf8(text_of(feature, i), was_latin1);
    if (value.empty()) continue;
    if (was_latin1) into.notes.push_back("its attribute '" + name + "' is not UTF-8, and is read as Latin-1");
    into.attributes[name] = value;
    into.attribute_order.push_back(name);
  }
}

/// A code where the definition is, beyond doubt, one of EPSG's, else WKT. Absent: the file has no usable CRS.
std::optional<std::string> definition(const OGRSpatialReference* srs) {
  if (srs == nullptr || srs->IsEmpty()) return std::nullopt;
  const char* name = srs->GetName();
  if (name != nullptr && std::string_view{name}.starts_with("Undefined "))
    return std::nullopt;  // of GeoPackages
  OGRSpatialReference flat{*srs};
  flat.StripVertical();
  const auto code = [](const OGRSpatialReference& one) -> std::optional<std::string> {
    const char* authority = one.GetAuthorityName(nullptr);
    const char* number = one.GetAuthorityCode(nullptr);
    if (authority == nullptr || number == nullptr) return std::nullopt;
    return std::string{authority} + ":" + number;
  };
  if (auto own = code(flat)) return own;
  constexpr int kSure = 90;
  const std::unique_ptr<OGRSpatialReference> match{flat.FindBestMatch(kSure, nullptr, nullptr)};
  if (match) return code(*match);
  char* wkt = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  flat.exportToWkt(&wkt, options.data());
  std::string text = wkt == nullptr ? "" : wkt;
  CPLFree(wkt);
  return text;
}

/// Vector drivers give x (easting, longitude) first, whatever the CRS says, unless they say that they do not.
bool northing_first(const OGRSpatialReference* srs) {
  return srs != nullptr && srs->GetAxisMappingStrategy() == OAMS_AUTHORITY_COMPLIANT &&
         (srs->EPSGTreatsAsLatLong() != 0 || srs->EPSGTreatsAsNorthingEasting() != 0);
}

}  // namespace

RawLayer read_layer(OGRLayer& layer, std::span<const std::string_view> skipped_attributes) {
  RawLayer raw;
  raw.name = layer.GetName();
  raw.crs = definition(layer.GetSpatialRef());
  const bool swap = northing_first(layer.GetSpatialRef());
  layer.ResetReading();
  while (const auto feature = std::unique_ptr<OGRFeature>{layer.GetNextFeature()}) {
    RawFeature one;
    one.number = static_cast<int>(raw.features.size()) + 1;
    collect_attributes(*feature, skipped_attributes, one);
    if (feature->GetGeometryRef() != nullptr) collect(*feature->GetGeometryRef(), swap, one);
    raw.features.push_back(std::move(one));
  }
  return raw;
}

}  // namespace selion
