// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "selion/plan/job_keys.hpp"

namespace selion {

/// A value given for one key, and where it was given ("job.toml:3:1", "--working-width") for messages.
struct JobSetting {
  const JobKey* key;
  JobValue value;
  std::string where;
};
using JobSettings = std::vector<JobSetting>;

/// The settings of a job file's text; `where` names it in messages.
/// @throws InputError naming file, line and column, and the nearest key or value.
JobSettings settings_of_toml(std::string_view text, const std::string& where);

/// The same for a machine of one's own: a [machine] table, or its keys without the table.
JobSettings settings_of_machine_toml(std::string_view text, const std::string& where);

/// The effective job: defaults, then the preset's and the operation's, then `settings` in order (the last one
/// wins).
/// @throws InputError as validate(), beginning with where the value was given.
Job job_of(std::span<const JobSetting> settings);

/// The effective job as TOML, every key included; reading and printing it again gives the same bytes.
std::string job_toml(const Job& job);

/// The same keys and values as compact JSON, for the plan file.
std::string job_json(const Job& job);

}  // namespace selion
