// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "selion/field/read.hpp"
#include "selion/plan/job_keys.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace selion::cli {

/// Options of one command that stand under one heading of its help. `names` as CLI11 has them; what they are
/// bound to must live as long as the command.
class OptionGroup {
 public:
  OptionGroup(CLI::App& app, const char* heading) : app_{app}, heading_{heading} {}

  /// `type` names the value in the help.
  void text(const char* names, std::string& into, const char* type, const char* about) const;
  void flag(const char* names, bool& into, const char* about) const;
  void argument(const char* name, std::string& into, const char* about) const;
  void arguments(const char* name, std::vector<std::string>& into, const char* about) const;

 private:
  CLI::App& app_;
  const char* heading_;
};

// Options that commands share. Each struct holds what stood on the command line, as text; the functions below
// read it.

struct JobOptions {
  std::optional<std::string> file;
  std::map<std::string, std::string> flags;  ///< by the key's full name
};
std::shared_ptr<JobOptions> add_job_options(CLI::App& app);
/// The effective job: the file's settings, then the flags. @throws InputError
Job job_from(const JobOptions& options);

struct FieldOptions {
  std::optional<std::string> layer, crs, axis, field, obstacles, gates, accept_datum_error_m;
};
std::shared_ptr<FieldOptions> add_field_options(CLI::App& app);
/// Those of them that a check needs: not the datum's accuracy.
std::shared_ptr<FieldOptions> add_boundary_options(CLI::App& app);
/// @throws InputError
ReadOptions read_options_from(const FieldOptions& options);

/// Of `--threads`: all processors where nothing is given. @throws InputError
int threads_of(const std::string& text);
/// Of `--date`: a day, today, or none. @throws InputError
std::optional<std::string> date_of(const std::string& text);

}  // namespace selion::cli
