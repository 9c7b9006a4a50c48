// SPDX-License-Identifier: GPL-3.0-or-later
#include "help.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>

#include "selion/core/version.hpp"

namespace selion::cli {
namespace {

constexpr std::string_view kStatuses =
    "\nExit status\n"
    "  0    done\n"
    "  1    an error in selion itself; please report it\n"
    "  2    unusable input or options; of several fields the others are still planned\n"
    "  3    no feasible plan: the machine does not fit; the message says what is missing\n"
    "  4    done and written, but a check of the result failed\n"
    "  130  interrupted; nothing half-written is left\n";

constexpr std::size_t kWidth = 80;

/// `text` broken between words, every line but the first indented by `indent`.
std::string wrapped_text(std::string_view text, std::size_t indent) {
  std::string out;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t space = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, space);
    const bool first = column == indent;
    if (!first && column + 1 + word.size() > kWidth) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return out + "\n";
}

std::string option_text(const CLI::Option& option) {
  constexpr std::size_t kColumn = 30;
  const std::string type = option.get_type_name();
  const bool positional = option.get_positional();
  std::string names = option.get_name(positional, !positional);
  if (const std::size_t comma = names.find(','); comma != std::string::npos) names.insert(comma + 1, " ");
  std::string left = "  " + names + (type.empty() || positional ? "" : " " + type);
  if (left.size() + 2 > kColumn)
    left += "\n" + std::string(kColumn, ' ');
  else
    left.resize(kColumn, ' ');
  return left + wrapped_text(option.get_description(), kColumn);
}

std::string group_text(const CLI::App& app, const std::string& group) {
  std::string out;
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == group) out += option_text(*option);
  return out.empty() ? "" : "\n" + group + "\n" + out;
}

}  // namespace

std::string help_text() {
  std::string out =
      "selion plans farm fields: it reads field boundaries, lays out swaths and headland,\n"
      "and writes a map to print and paths to drive. It works offline.\n"
      "\nUsage: selion COMMAND [OPTIONS]\n\nCommands\n";
  for (const Command& command : commands()) {
    std::string left = "  " + std::string{command.name} + " " + std::string{command.arguments};
    left.resize(28, ' ');
    out += left + wrapped_text(command.about, left.size());
  }
  out +=
      "\nOptions\n  -h, --help                what this says\n  --version                 which selion this "
      "is\n";
  return out + std::string{kStatuses} + "\n'selion help COMMAND' explains a command and its options.\n";
}

std::string help_text(const Command& command) {
  CLI::App app;
  app.set_help_flag("-h,--help", "what this says")->group("Help");
  const Run never_run = command.setup(app);
  std::string out = "selion " + std::string{command.name} + ": " + std::string{command.about} +
                    "\n\nUsage: selion " + std::string{command.name} + " " + std::string{command.arguments} +
                    " [OPTIONS]\n";
  for (const std::string& group : app.get_groups())
    if (group != "Help") out += group_text(app, group);
  out += group_text(app, "Help");
  return out + "\nExamples\n" + std::string{command.examples} + std::string{kStatuses};
}

std::string version_text() { return "selion " + std::string{version()} + "\n"; }

Run setup_help(CLI::App& app) {
  auto name = std::make_shared<std::optional<std::string>>();
  app.add_option("COMMAND", *name, "the command to explain");
  return [name] {
    std::cout << (*name ? help_text(command_named(**name)) : help_text());
    return 0;
  };
}

}  // namespace selion::cli
