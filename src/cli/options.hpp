// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "selion/field/read.hpp"
#include "selion/plan/job_keys.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace selion::cli {

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
