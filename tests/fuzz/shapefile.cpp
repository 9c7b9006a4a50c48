// SPDX-License-Identifier: GPL-3.0-or-later
// The main file of a shapefile, alone: its index is made anew, its CRS given by hand.
#include "field/raw.hpp"
#include "reading.hpp"
#include "selion/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace selion;
  const std::string bytes = fuzz::text_of(data, size);
  try {
    check_shapefile(bytes, "fuzz");
  } catch (const InputError&) {
    return 0;
  }
  ReadOptions options;
  options.crs = "EPSG:4326";
  fuzz::read_and_clean(bytes, ".shp", options);
  return 0;
}
