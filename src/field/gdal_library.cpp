// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdal_library.hpp"

#include <string>

#include <dlfcn.h>

#include "selion/core/error.hpp"

namespace selion {
namespace {

[[noreturn]] void refuse() {
  const char* why = ::dlerror();
  throw InputError{std::string{"GDAL, which reads this kind of file, cannot be used ("} +
                   (why == nullptr ? SELION_GDAL_LIBRARY : why) +
                   "); install it, or give the field as GeoJSON or CSV"};
}

void* loaded() {
  void* library = ::dlopen(SELION_GDAL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) refuse();
  return library;
}

}  // namespace

void* gdal_function(const char* name) {
  static void* const library = loaded();
  void* function = ::dlsym(library, name);
  if (function == nullptr) refuse();
  return function;
}

}  // namespace selion
