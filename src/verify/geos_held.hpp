// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geos.hpp"

struct GEOSContextHandle_HS;

namespace selion::verifying {

/// One for each thread: GEOS's handles are not shared between threads.
GEOSContextHandle_HS* handle();
/// Takes `geometry`, which may be null, over.
Shape held(GEOSGeom_t* geometry);

}  // namespace selion::verifying
