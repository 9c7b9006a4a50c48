// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_layer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include <cpl_error.h>
#include <ogr_api.h>

#include "letters.hpp"
#include "ogr.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// Those that have a value.
Attributes attributes_of(OGRFeatureH feature) {
  Attributes attributes;
  for (int i = 0; i < SELION_OGR(OGR_F_GetFieldCount)(feature); ++i)
    if (SELION_OGR(OGR_F_IsFieldSetAndNotNull)(feature, i) != 0)
      attributes.emplace_back(SELION_OGR(OGR_Fld_GetNameRef)(SELION_OGR(OGR_F_GetFieldDefnRef)(feature, i)),
                              SELION_OGR(OGR_F_GetFieldAsString)(feature, i));
  std::erase_if(attributes, [](const auto& one) { return one.second.empty(); });
  return attributes;
}

/// The value of that key, else of one that differs in case only; empty where there is none.
std::string value_of(const Attributes& attributes, std::string_view key) {
  for (const auto& [name, value] : attributes)
    if (name == key) return value;
  for (const auto& [name, value] : attributes)
    if (lower(name) == key) return value;
  return {};
}

std::string name_of(const Attributes& attributes) {
  for (const std::string_view key :
       {"name", "field", "field_name", "fieldname", "title", "label", "id", "uid", "fid"})
    for (const auto& [name, value] : attributes)
      if (lower(name) == key) return value;
  return {};
}

std::optional<OwnerRole> own_role(const Attributes& attributes, const std::string& where) {
  const std::string word = value_of(attributes, "selion");
  if (word.empty()) return std::nullopt;
  if (lower(word) == "field") return OwnerRole::field;
  if (const auto role = role_named(word)) return role;
  throw InputError{where + ": its property selion is '" + word +
                   "', but must be field, obstacle, gate, no_go or water"};
}

std::optional<double> metres_of(const Attributes& attributes, const char* key, const std::string& where) {
  const std::string text = value_of(attributes, key);
  if (text.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && value > 0 && std::isfinite(value))
    return value;
  throw InputError{where + ": its " + key + " is '" + text + "', but must be a positive number of metres"};
}

LonLatLine line_of(OGRGeometryH line, const ToWgs84& to_wgs84) {
  LonLatLine places;
  const auto x = SELION_OGR(OGR_G_GetX);
  const auto y = SELION_OGR(OGR_G_GetY);
  for (int i = 0; i < SELION_OGR(OGR_G_GetPointCount)(line); ++i)
    places.push_back(to_wgs84(x(line, i), y(line, i)));
  return places;
}

LonLatArea area_of(OGRGeometryH polygon, const ToWgs84& to_wgs84) {
  LonLatArea area;
  for (int i = 0; i < SELION_OGR(OGR_G_GetGeometryCount)(polygon); ++i) {
    LonLatLine ring = line_of(SELION_OGR(OGR_G_GetGeometryRef)(polygon, i), to_wgs84);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < 3) continue;
    if (i == 0)
      area.shell = std::move(ring);
    else
      area.holes.push_back(std::move(ring));
  }
  return area;
}

bool is_gate(OwnerRole role) { return role == OwnerRole::gate; }

void add_geometry(OwnerFeature& feature, OGRGeometryH geometry, const ToWgs84& to_wgs84) {
  if (geometry == nullptr || SELION_OGR(OGR_G_IsEmpty)(geometry) != 0) return;
  switch (SELION_OGR(OGR_GT_Flatten)(SELION_OGR(OGR_G_GetGeometryType)(geometry))) {
    case wkbPolygon:
    case wkbTriangle:
      if (LonLatArea area = area_of(geometry, to_wgs84); !area.shell.empty())
        feature.parts.push_back(std::move(area));
      break;
    case wkbLineString:
      if (is_obstacle(feature.role)) feature.lines.push_back(line_of(geometry, to_wgs84));
      break;
    case wkbPoint:
      if (is_obstacle(feature.role) || is_gate(feature.role))
        feature.points.push_back(line_of(geometry, to_wgs84).front());
      break;
    default:
      for (int i = 0; i < SELION_OGR(OGR_G_GetGeometryCount)(geometry); ++i)
        add_geometry(feature, SELION_OGR(OGR_G_GetGeometryRef)(geometry, i), to_wgs84);
  }
}

OwnerFeature feature_of(OGRFeatureH raw, const std::string& where, const OwnerLayer& layer,
                        const ToWgs84& to_wgs84) {
  const Attributes attributes = attributes_of(raw);
  OwnerFeature feature;
  feature.where = where;
  feature.name = name_of(attributes);
  feature.role = own_role(attributes, where).value_or(layer.role);
  if (feature.role == OwnerRole::field) feature.role = layer.fields;
  OGRGeometryH geometry = SELION_OGR(OGR_F_GetGeometryRef)(raw);
  const std::unique_ptr<void, void (*)(void*)> straight{
      geometry == nullptr ? nullptr : SELION_OGR(OGR_G_GetLinearGeometry)(geometry, 0.5, nullptr),
      SELION_OGR(OGR_G_DestroyGeometry)};
  add_geometry(feature, straight.get(), to_wgs84);
  if (feature.role == OwnerRole::field) return feature;
  feature.width_m = metres_of(attributes, "width_m", where);
  if (is_gate(feature.role)) return feature;
  feature.radius_m = metres_of(attributes, "radius_m", where);
  if (!feature.points.empty() && !feature.radius_m)
    throw InputError{where + " is an obstacle given as a point: give its size as a property radius_m"};
  return feature;
}

}  // namespace

bool is_obstacle(OwnerRole role) { return role != OwnerRole::field && role != OwnerRole::gate; }

std::optional<OwnerRole> role_named(const std::string& word) {
  std::string name = lower(word);
  std::ranges::replace_if(
      name, [](char c) { return c == '-' || c == ' '; }, '_');
  if (name == "water") return OwnerRole::water;
  if (name == "gate" || name == "gates") return OwnerRole::gate;
  if (name == "no_go" || name == "nogo") return OwnerRole::no_go;
  if (name == "obstacle" || name == "obstacles") return OwnerRole::obstacle;
  return std::nullopt;
}

void add_features(std::vector<OwnerFeature>& features, const OwnerLayer& from) {
  const ToWgs84 to_wgs84 = to_wgs84_of(from.crs);
  const auto next = SELION_OGR(OGR_L_GetNextFeature);
  const auto destroy = SELION_OGR(OGR_F_Destroy);
  SELION_OGR(OGR_L_ResetReading)(from.handle);
  SELION_OGR(CPLErrorReset)();
  for (long long number = 1;; ++number) {
    const std::unique_ptr<void, void (*)(void*)> raw{next(from.handle), destroy};
    if (!raw) break;
    OwnerFeature feature =
        feature_of(raw.get(), from.crs.where + ", feature " + std::to_string(number), from, to_wgs84);
    feature.number = number;
    if (feature.role != OwnerRole::field || !feature.parts.empty()) features.push_back(std::move(feature));
  }
  if (SELION_OGR(CPLGetLastErrorType)() >= CE_Failure)
    throw InputError{from.crs.where + " cannot be read to its end: " + SELION_OGR(CPLGetLastErrorMsg)()};
}

}  // namespace selion::verifying
