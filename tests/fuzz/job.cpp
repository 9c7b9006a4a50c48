// SPDX-License-Identifier: GPL-3.0-or-later
// The job file and the machine file; a job that is taken is printed and read again to the same.
#include <stdexcept>

#include "reading.hpp"
#include "selion/core/error.hpp"
#include "selion/plan/job_file.hpp"

namespace {

void read(const std::string& text, selion::JobSettings (*settings_of)(std::string_view, const std::string&)) {
  selion::Job job;
  try {
    job = selion::job_of(settings_of(text, "fuzz.toml"));
  } catch (const selion::InputError&) {
    return;
  }
  const std::string printed = selion::job_toml(job);
  const selion::Job again = selion::job_of(selion::settings_of_toml(printed, "printed.toml"));
  if (selion::job_toml(again) != printed || selion::job_json(again) != selion::job_json(job))
    throw std::logic_error{"the printed job reads back as another"};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = selion::fuzz::text_of(data, size);
  read(text, selion::settings_of_toml);
  read(text, selion::settings_of_machine_toml);
  return 0;
}
