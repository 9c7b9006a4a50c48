// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "raw.hpp"

namespace selion {

/// All features of a layer that GDAL has opened (an OGRLayerH), curves as chords.
RawLayer read_layer(void* opened, std::span<const std::string_view> skipped_attributes);

}  // namespace selion
