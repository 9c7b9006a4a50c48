// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace selion::verifying {

/// A function of GDAL's library, which is loaded when the first file needs it: it takes longer than a plan.
/// @throws InputError where it is not installed.
void* ogr_function(const char* name);

}  // namespace selion::verifying

#define SELION_OGR(name) (reinterpret_cast<decltype(&::name)>(::selion::verifying::ogr_function(#name)))
