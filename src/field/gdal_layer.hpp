// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "raw.hpp"

class OGRLayer;

namespace selion {

/// All features of a layer that GDAL has opened, curves as chords.
RawLayer read_layer(OGRLayer& layer, std::span<const std::string_view> skipped_attributes);

}  // namespace selion
