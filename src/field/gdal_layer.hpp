// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "raw.hpp"

namespace selion {

/// The features of a layer that GDAL has opened (an OGRLayerH), curves as chords. Valid as long as the layer.
class LayerCursor {
 public:
  /// At the first feature.
  LayerCursor(void* opened, std::vector<std::string_view> skipped_attributes);

  [[nodiscard]] RawLayer about() const;  ///< without features
  std::optional<RawFeature> next();
  /// The feature with this id, to be called `number`. Some drivers lose their place in the layer by it.
  [[nodiscard]] std::optional<RawFeature> at(std::int64_t id, int number) const;

 private:
  [[nodiscard]] RawFeature raw_of(void* feature, int number) const;

  void* layer_;
  std::vector<std::string_view> skipped_;
  bool swap_;  // GDAL gives y first
  int count_ = 0;
};

/// All features of such a layer.
RawLayer read_layer(void* opened, std::span<const std::string_view> skipped_attributes);

}  // namespace selion
