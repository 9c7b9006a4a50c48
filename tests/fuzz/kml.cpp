// SPDX-License-Identifier: GPL-3.0-or-later
// KML, and whatever XML it turns into.
#include "field/raw.hpp"
#include "reading.hpp"
#include "selion/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace selion;
  const std::string text = fuzz::text_of(data, size);
  try {
    static_cast<void>(check_xml(text, "fuzz"));
  } catch (const InputError&) {
    return 0;
  }
  fuzz::read_and_clean(text, ".kml", {});
  return 0;
}
