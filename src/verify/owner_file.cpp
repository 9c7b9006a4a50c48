// SPDX-License-Identifier: GPL-3.0-or-later
#include "owner_file.hpp"

#include <algorithm>
#include <memory>

#include <gdal.h>
#include <ogr_api.h>

#include "ogr.hpp"
#include "owner_layer.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

using Dataset = std::unique_ptr<void, void (*)(void*)>;

Dataset opened(const std::filesystem::path& file) {
  SELION_OGR(GDALAllRegister)();
  const std::string path = file.extension() == ".zip" ? "/vsizip/" + file.string() : file.string();
  Dataset data{
      SELION_OGR(GDALOpenEx)(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr),
      [](void* open) {
        if (open != nullptr) SELION_OGR(GDALClose)(open);
      }};
  if (!data)
    throw InputError{file.string() + ": OGR cannot read it; give the field as a vector file with polygons"};
  return data;
}

std::vector<OwnerLayer> layers_of(const Dataset& data, const std::string& file) {
  std::vector<OwnerLayer> layers;
  const int count = SELION_OGR(GDALDatasetGetLayerCount)(data.get());
  const std::string where = count > 1 ? file + ", layer " : file;
  for (int i = 0; i < count; ++i) {
    OGRLayerH layer = SELION_OGR(GDALDatasetGetLayer)(data.get(), i);
    const std::string name = SELION_OGR(OGR_L_GetName)(layer);
    layers.push_back({layer, name, count > 1 ? where + name : where});
  }
  return layers;
}

/// Fields of the layer asked for, or of all; obstacles of layers so called beside.
void add_file(std::vector<OwnerFeature>& features, const GivenField& given) {
  const Dataset data = opened(given.file);
  std::vector<OwnerLayer> layers = layers_of(data, given.file.string());
  for (OwnerLayer& layer : layers) {
    const bool wanted = given.layer == layer.name;
    // One that is alone or asked for holds fields whatever it is called.
    const auto role = wanted || layers.size() == 1 ? std::nullopt : role_named(layer.name);
    if (given.layer && !wanted && !role) continue;
    layer.role = role.value_or(OwnerRole::field);
    add_features(features, layer, to_wgs84_of(layer.opened));
  }
  if (std::ranges::count(features, OwnerRole::field, &OwnerFeature::role) == 0)
    throw InputError{given.file.string() + ": there is no polygon in it" +
                     (given.layer ? " in layer " + *given.layer : "")};
}

void add_obstacles(std::vector<OwnerFeature>& features, const std::filesystem::path& file) {
  const Dataset data = opened(file);
  for (OwnerLayer& layer : layers_of(data, file.string())) {
    layer.fields = OwnerRole::obstacle;
    layer.role = role_named(layer.name).value_or(OwnerRole::obstacle);
    add_features(features, layer, to_wgs84_of(layer.opened));
  }
}

}  // namespace

std::vector<OwnerFeature> read_owner_file(const GivenField& given) {
  std::vector<OwnerFeature> features;
  add_file(features, given);
  if (given.obstacles) add_obstacles(features, *given.obstacles);
  return features;
}

}  // namespace selion::verifying
