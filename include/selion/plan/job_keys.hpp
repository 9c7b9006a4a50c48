// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "selion/plan/job.hpp"

namespace selion {

/// A key's value as a job file writes it; `Absent` is written as the key's own word ("auto", "unknown", []).
struct Absent {
  friend bool operator==(const Absent&, const Absent&) = default;
};
using JobValue = std::variant<Absent, double, bool, std::string, std::vector<double>>;

enum class JobType { number, count, truth, text, heading, line };

/// One key of the job file. Flags, reading, printing, help and docs/job.md all come from the table of these.
struct JobKey {
  std::string_view table;  ///< "machine"; empty at the top of the file
  std::string_view name;   ///< "working_width_m"
  std::string_view flag;   ///< "--working-width"
  std::string_view alias;  ///< a second flag; mostly empty
  JobType type;
  std::string_view unit;     ///< for people: "m/s"; empty where there is none
  std::string_view choices;  ///< "A4|A3|letter"; empty where any text of the type will do
  std::string_view later;    ///< choices of a later version, refused as not supported yet
  std::string_view absent;   ///< the word for no value: "auto"; empty where a value is needed
  std::string_view help;
  JobValue (*get)(const Job&);
  void (*set)(Job&, const JobValue&);
};

/// Every key, table by table, in the order in which a job is printed.
std::span<const JobKey> job_keys();

/// "machine.working_width_m", "operation".
std::string full_name(const JobKey& key);
/// @throws std::logic_error where the table has no such key.
const JobKey& job_key(std::string_view full);

/// `value` checked and brought into the key's own type.
/// @throws InputError where it does not fit, naming what does (and the nearest one), or what is not supported
/// yet.
JobValue fitted(const JobKey& key, const JobValue& value);
/// The same for a flag's text: "4", "true", "auto", "3.43,46.33,3.44,46.34".
JobValue value_of_text(const JobKey& key, std::string_view text);
/// As a job file (and, up to the brackets of nothing, as JSON) writes it: 0.3, true, "A4",
/// [3.43, 46.33, 3.44, 46.34].
std::string text_of_value(const JobKey& key, const JobValue& value);

}  // namespace selion
