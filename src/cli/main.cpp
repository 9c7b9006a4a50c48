// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "help.hpp"
#include "interrupt.hpp"
#include "selion/core/error.hpp"
#include "selion/plan/suggest.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

enum Status { done = 0, internal_error = 1, unusable_input = 2 };

/// An option of a later version, or one that nobody knows: the nearest one there is.
std::string unknown_option(const CLI::App& app, const std::string& given) {
  const std::string option = given.substr(0, given.find('='));
  if (option == "--robots" || option == "--fleet")
    return option + " is not supported yet; a plan is for one machine";
  if (option == "--export" || option == "--to")
    return option + " is not supported yet; there is plan.geojson, which any GIS opens";
  std::vector<std::string> names{"--help"};
  for (const CLI::Option* known : app.get_options())
    for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
  const std::vector<std::string_view> views{names.begin(), names.end()};
  return "unknown option '" + option + "'" + did_you_mean(option, views);
}

void check_rest(const CLI::App& app) {
  for (const std::string& rest : app.remaining()) {
    if (rest.starts_with('-') && rest.size() > 1) throw InputError{unknown_option(app, rest)};
    throw InputError{"'" + rest + "' is one argument too many"};
  }
}

int run_command(const Command& command, std::vector<std::string> arguments) {
  CLI::App app{std::string{command.about}};
  app.allow_extras();
  const Run run = command.setup(app);
  std::ranges::reverse(arguments);  // CLI11 takes them from the back
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::CallForHelp&) {
    std::cout << help_text(command);
    return done;
  } catch (const CLI::ParseError& error) {
    throw InputError{error.what()};
  }
  check_rest(app);
  return run();
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    std::cerr << help_text();
    return unusable_input;
  }
  const std::string& first = arguments.front();
  if (first == "--version" || first == "-V") {
    std::cout << version_text();
    return done;
  }
  if (first == "--help" || first == "-h") {
    std::cout << help_text();
    return done;
  }
  if (first.starts_with('-'))
    throw InputError{"'" + first + "' stands before the command; 'selion help' shows how to call it"};
  return run_command(command_named(first), {arguments.begin() + 1, arguments.end()});
}

int checked_run(const std::vector<std::string>& arguments) {
  Terminal terminal{Loudness::normal};
  try {
    const int status = run(arguments);
    std::cout.flush();
    if (!std::cout) throw InputError{"standard output cannot be written"};
    return status;
  } catch (const InputError& error) {
    terminal.error(error.what());
    return unusable_input;
  } catch (const std::exception& error) {
    terminal.error(std::string{"selion failed, and should not have: "} + error.what() +
                   "; please report it with the command and the file");
    return internal_error;
  }
}

}  // namespace
}  // namespace selion::cli

int main(int argc, char** argv) {
  selion::cli::watch_for_interrupts();
  return selion::cli::checked_run({argv + std::min(argc, 1), argv + argc});
}
