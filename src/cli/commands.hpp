// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 calls it so
class App;
}

namespace selion::cli {

/// Does the work of a command whose options have been read; returns the exit status.
using Run = std::function<int()>;

Run setup_plan(CLI::App& app);
Run setup_batch(CLI::App& app);
Run setup_inspect(CLI::App& app);
Run setup_verify(CLI::App& app);
Run setup_help(CLI::App& app);

struct Command {
  std::string_view name;
  std::string_view arguments;  ///< as the usage line has them
  std::string_view about;
  std::string_view examples;  ///< whole lines, each ended
  Run (*setup)(CLI::App&);    ///< declares options, opens nothing
};

/// The commands that there are, in the order of the help.
std::span<const Command> commands();
/// @throws InputError naming the nearest command, or saying that this one comes in a later version.
const Command& command_named(std::string_view name);

}  // namespace selion::cli
