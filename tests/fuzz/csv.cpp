// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinates as text, in either order and in degrees or metres: the first byte chooses.
#include "field/raw.hpp"
#include "reading.hpp"
#include "selion/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace selion;
  if (size == 0) return 0;
  ReadOptions options;
  if ((data[0] & 1U) != 0) options.axis = AxisOrder::latlon;
  if ((data[0] & 2U) != 0) options.crs = "EPSG:25832";
  try {
    const RawFile file = read_text(fuzz::text_of(data + 1, size - 1), "fuzz", "fuzz", options);
    if (!options.crs) fuzz::locate_and_clean(file);
  } catch (const InputError&) {  // said so
  }
  return 0;
}
