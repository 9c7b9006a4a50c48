// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace selion::cli {

enum class Loudness { quiet, normal };

/// `text` without control characters and marks that turn the direction of text: names from files may hold
/// what would rule the terminal.
std::string printable(std::string_view text);

/// What is said on standard error, and results beside it. Safe to use from several threads.
class Terminal {
 public:
  explicit Terminal(Loudness loudness);
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  Terminal(Terminal&&) = delete;
  Terminal& operator=(Terminal&&) = delete;
  ~Terminal();

  void note(std::string_view text);  ///< not where quiet
  void warning(std::string_view text);
  void error(std::string_view text);
  /// On standard output, not on top of the progress line.
  void result(std::string_view text);
  /// One line, drawn over the last one; only on a terminal, and not where quiet.
  void progress(std::string_view what, double share);

 private:
  void say(std::string_view colour, std::string_view label, std::string_view text);
  void clear_line();

  std::mutex mutex_;
  bool quiet_;
  bool draws_;
  bool colours_;
  std::string line_;  // the progress that is on the screen
};

}  // namespace selion::cli
