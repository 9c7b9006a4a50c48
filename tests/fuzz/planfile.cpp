// SPDX-License-Identifier: GPL-3.0-or-later
// The plan file: one that is taken can be written, and what is written reads back as the same bytes. What is
// read the short way comes out the same the long way, which a byte order mark forces.
#include "selion/planfile/planfile.hpp"

#include <stdexcept>

#include "planfile/json_value.hpp"
#include "reading.hpp"
#include "selion/core/error.hpp"

namespace {

struct Outcome {
  bool taken = false;
  std::string text;  // the plan as it is written, or why it is refused

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome(const std::string& text) {
  selion::PlanFile plan;
  try {
    plan = selion::plan_from_geojson(text, "fuzz");
  } catch (const selion::InputError& refused) {
    return {false, refused.what()};
  }
  return {true, selion::to_geojson(plan)};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = selion::fuzz::text_of(data, size);
  const Outcome read = outcome(text);
  if (read.taken && outcome(read.text) != read)
    throw std::logic_error{"the written plan reads back as another"};
  if (selion::plain_values(text) && outcome("\xef\xbb\xbf" + text) != read)
    throw std::logic_error{"the long way of reading reads another plan"};
  return 0;
}
