// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace selion {

/// The address of a function of GDAL's C interface, never null. The first call loads GDAL: it brings a
/// hundred libraries along, whose start takes longer than a plan, so only files that GDAL is needed for pay
/// for it.
/// @throws InputError where GDAL is not installed, or not as the program was built for.
void* gdal_function(const char* name);

}  // namespace selion

/// A function of GDAL's C interface, with the type that its header gives it; looked up once.
#define SELION_GDAL(name)                                                                       \
  ([] {                                                                                         \
    static const auto gdal_address = reinterpret_cast<decltype(&(name))>(gdal_function(#name)); \
    return gdal_address;                                                                        \
  }())
