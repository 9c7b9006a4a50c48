// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>
#include <string>

#include "selion/core/error.hpp"
#include "selion/plan/job_file.hpp"

namespace selion {
namespace {

const JobSetting* last_of(std::span<const JobSetting> settings, std::string_view full) {
  const auto found = std::find_if(settings.rbegin(), settings.rend(),
                                  [&](const JobSetting& setting) { return full_name(*setting.key) == full; });
  return found == settings.rend() ? nullptr : &*found;
}

void start_from_preset(Job& job, std::string_view name) {
  const auto presets = machine_presets();
  const auto preset = std::ranges::find(presets, name, &MachinePreset::name);
  if (preset == presets.end()) throw std::logic_error{"a preset was not checked before it was set"};
  job.machine = preset->machine;
  job.machine_assumed = false;
  job.field.edge_margin_m = preset->edge_margin_m;
  job.field.obstacle_clearance_m = preset->obstacle_clearance_m;
}

/// A message of validate() begins with a key: put before it where that key was given.
std::string placed_message(const std::string& message, std::span<const JobSetting> settings) {
  const JobSetting* setting = last_of(settings, message.substr(0, message.find(' ')));
  return setting == nullptr ? message : setting->where + ": " + message;
}

}  // namespace

HeadlandOrder usual_headland_order(Operation operation) {
  switch (operation) {
    case Operation::tillage:
    case Operation::seeding:
    case Operation::weeding:
      return HeadlandOrder::last;
    case Operation::spraying:
    case Operation::mowing:
    case Operation::harvest:
      return HeadlandOrder::first;
    case Operation::scouting:
      return HeadlandOrder::none;
  }
  throw std::logic_error{"an operation without a usual headland order"};
}

Job job_of(std::span<const JobSetting> settings) {
  Job job;
  if (const JobSetting* preset = last_of(settings, "machine.preset"))
    start_from_preset(job, std::get<std::string>(preset->value));
  if (const JobSetting* operation = last_of(settings, "operation"))
    operation->key->set(job, operation->value);
  job.headland.order = usual_headland_order(job.operation);
  for (const JobSetting& setting : settings) setting.key->set(job, setting.value);
  try {
    validate(job);
  } catch (const InputError& error) {
    throw InputError{placed_message(error.what(), settings)};
  }
  return job;
}

}  // namespace selion
