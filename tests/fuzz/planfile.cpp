// SPDX-License-Identifier: GPL-3.0-or-later
// The plan file: one that is taken can be written, and what is written reads back as the same bytes.
#include "selion/planfile/planfile.hpp"

#include <stdexcept>

#include "reading.hpp"
#include "selion/core/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  selion::PlanFile plan;
  try {
    plan = selion::plan_from_geojson(selion::fuzz::text_of(data, size), "fuzz");
  } catch (const selion::InputError&) {
    return 0;
  }
  const std::string written = selion::to_geojson(plan);
  if (selion::to_geojson(selion::plan_from_geojson(written, "written")) != written)
    throw std::logic_error{"the written plan reads back as another"};
  return 0;
}
