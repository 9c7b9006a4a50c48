// SPDX-License-Identifier: GPL-3.0-or-later
#include "ogr.hpp"

#include <dlfcn.h>

#include "selion/core/error.hpp"

namespace selion::verifying {

void* ogr_function(const char* name) {
  static void* const library = ::dlopen(SELION_GDAL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  void* found = library == nullptr ? nullptr : ::dlsym(library, name);
  if (found == nullptr)
    throw InputError{"reading this field needs GDAL (" SELION_GDAL_LIBRARY "), which is not installed here"};
  return found;
}

}  // namespace selion::verifying
