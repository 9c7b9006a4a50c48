// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_file.hpp"

#include <algorithm>

#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>

#include "ogr.hpp"
#include "owner_data.hpp"
#include "owner_layer.hpp"
#include "owner_text.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

/// Keeps OGR from writing to the terminal.
class Silence {
 public:
  Silence() { SELION_OGR(CPLPushErrorHandler)(SELION_OGR(CPLQuietErrorHandler)); }
  ~Silence() { SELION_OGR(CPLPopErrorHandler)(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  Silence(Silence&&) = delete;
  Silence& operator=(Silence&&) = delete;
};

OwnerFeature text_feature(const std::filesystem::path& file, const GivenField& given, OwnerRole role) {
  OwnerFeature feature;
  feature.where = file.string();
  feature.name = file.stem().string();
  feature.role = role;
  feature.number = 1;
  const ToWgs84 to_wgs84 =
      given.crs ? to_wgs84_of({.option = given.crs, .where = file.string()}) : as_they_are(file.string());
  feature.parts.push_back(read_coordinate_text(file, given.order, to_wgs84));
  return feature;
}

std::vector<OwnerLayer> layers_of(const std::vector<OwnerData>& all, const GivenField& given) {
  std::vector<OwnerLayer> layers;
  for (const OwnerData& data : all) {
    const int count = SELION_OGR(GDALDatasetGetLayerCount)(data.handle.get());
    const bool plain = count == 1 && is_plain_geojson(data);
    const std::string where = count > 1 ? data.label + ", layer " : data.label;
    for (int i = 0; i < count; ++i) {
      OGRLayerH layer = SELION_OGR(GDALDatasetGetLayer)(data.handle.get(), i);
      const std::string name = SELION_OGR(OGR_L_GetName)(layer);
      OwnerCrs crs{SELION_OGR(OGR_L_GetSpatialRef)(layer), {}, given.crs, count > 1 ? where + name : where};
      if (plain) crs.of_layer = nullptr, crs.usual = "OGC:CRS84";
      layers.push_back({layer, name, std::move(crs)});
    }
  }
  return layers;
}

/// Fields of the layer asked for, or of all; obstacles of layers so called beside.
void add_file(std::vector<OwnerFeature>& features, const GivenField& given) {
  const std::vector<OwnerData> data = owner_data(given.file);
  std::vector<OwnerLayer> layers = layers_of(data, given);
  for (OwnerLayer& layer : layers) {
    const bool wanted = given.layer == layer.name;
    // One that is alone or asked for holds fields whatever it is called.
    const auto role = wanted || layers.size() == 1 ? std::nullopt : role_named(layer.name);
    if (given.layer && !wanted && !role) continue;
    layer.role = role.value_or(OwnerRole::field);
    add_features(features, layer);
  }
  if (std::ranges::count(features, OwnerRole::field, &OwnerFeature::role) == 0)
    throw InputError{given.file.string() + ": there is no polygon in it" +
                     (given.layer ? " in layer " + *given.layer : "")};
}

/// Whatever their layers are called.
void add_gates(std::vector<OwnerFeature>& features, const GivenField& given) {
  const std::vector<OwnerData> data = owner_data(*given.gates);
  for (OwnerLayer& layer : layers_of(data, given)) {
    layer.fields = layer.role = OwnerRole::gate;
    add_features(features, layer);
  }
}

void add_obstacles(std::vector<OwnerFeature>& features, const GivenField& given) {
  const std::vector<OwnerData> data = owner_data(*given.obstacles);
  for (OwnerLayer& layer : layers_of(data, given)) {
    layer.fields = OwnerRole::obstacle;
    layer.role = role_named(layer.name).value_or(OwnerRole::obstacle);
    add_features(features, layer);
  }
}

}  // namespace

std::vector<OwnerFeature> read_owner_file(const GivenField& given) {
  std::vector<OwnerFeature> features;
  const auto add = [&](const std::filesystem::path& file, OwnerRole role, const auto& add_by_ogr) {
    if (is_coordinate_text(file)) {
      features.push_back(text_feature(file, given, role));
    } else {
      const Silence silence;
      add_by_ogr(features, given);
    }
  };
  add(given.file, OwnerRole::field, add_file);
  if (given.obstacles) add(*given.obstacles, OwnerRole::obstacle, add_obstacles);
  if (given.gates) add(*given.gates, OwnerRole::gate, add_gates);
  return features;
}

}  // namespace selion::verifying
