// SPDX-License-Identifier: GPL-3.0-or-later
#include "raw_stream.hpp"

#include <memory>

namespace selion {
namespace {

/// A file that was read at once.
struct Held {
  std::vector<RawLayer> layers;
  std::size_t layer = 0;
  std::size_t next = 0;
};

RawStream stream_of(RawFile file) {
  const auto held = std::make_shared<Held>();
  held->layers = std::move(file.layers);
  RawStream stream;
  stream.about = std::move(file);
  stream.about.layers.clear();
  for (RawLayer& layer : held->layers) {
    for (std::size_t i = 0; i < layer.features.size(); ++i)
      layer.features[i].id = static_cast<std::int64_t>(i);
    stream.about.layers.push_back({layer.name, layer.crs, layer.crs_is_default, {}});
  }
  stream.rewind = [held](std::size_t layer) { held->layer = layer, held->next = 0; };
  stream.next = [held]() -> std::optional<RawFeature> {
    const std::vector<RawFeature>& features = held->layers[held->layer].features;
    if (held->next >= features.size()) return std::nullopt;
    return features[held->next++];
  };
  stream.at = [held](std::size_t layer, std::int64_t id, int /*number*/) -> std::optional<RawFeature> {
    return held->layers[layer].features[static_cast<std::size_t>(id)];
  };
  return stream;
}

}  // namespace

RawStream raw_stream(const std::filesystem::path& path, const ReadOptions& options,
                     std::istream& standard_input) {
  if (is_for_gdal(path))
    if (auto stream = stream_with_gdal(path, path.string())) return std::move(*stream);
  return stream_of(read_raw(path, options, standard_input));
}

}  // namespace selion
