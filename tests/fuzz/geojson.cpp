// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON, its notes and roles too; what other JSON there is goes to GDAL.
#include "field/raw.hpp"
#include "reading.hpp"
#include "selion/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace selion;
  const std::string text = fuzz::text_of(data, size);
  try {
    static_cast<void>(read_json(text, "fuzz", "fuzz"));  // the most there is to find, without a PROJ object
  } catch (const InputError&) {
    return 0;
  }
  fuzz::read_and_clean(text, ".geojson", {});
  return 0;
}
