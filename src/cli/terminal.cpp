// SPDX-License-Identifier: GPL-3.0-or-later
#include "terminal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include <unistd.h>

namespace selion::cli {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool is_dumb() {
  const char* kind = std::getenv("TERM");
  return kind == nullptr || std::string_view{kind} == "dumb";
}

/// Bytes of the control character, or of the mark that turns the direction of text, which `text` begins with;
/// 0: of none.
std::size_t ruling_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  if (byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0) return 2;
  const bool embeds = byte(1) == 0x80 && byte(2) >= 0xaa && byte(2) <= 0xae;    // U+202A to U+202E
  const bool isolates = byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9;  // U+2066 to U+2069
  return byte(0) == 0xe2 && (embeds || isolates) ? 3 : 0;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t ruling = ruling_bytes(text);
    out += ruling > 0 ? ' ' : text.front();
    text.remove_prefix(std::max<std::size_t>(ruling, 1));
  }
  return out;
}

Terminal::Terminal(Loudness loudness)
    : quiet_{loudness == Loudness::quiet},
      draws_{!quiet_ && isatty(STDERR_FILENO) != 0 && !is_dumb()},
      colours_{isatty(STDERR_FILENO) != 0 && !is_dumb() && !is_set("NO_COLOR")} {}

Terminal::~Terminal() { clear_line(); }

void Terminal::clear_line() {
  if (!line_.empty()) std::cerr << "\r\x1b[K" << std::flush;
  line_.clear();
}

void Terminal::say(std::string_view colour, std::string_view label, std::string_view text) {
  const std::scoped_lock lock{mutex_};
  clear_line();
  if (colours_)
    std::cerr << "\x1b[" << colour << "m" << label << "\x1b[0m ";
  else
    std::cerr << label << ' ';
  std::cerr << printable(text) << '\n';
}

void Terminal::note(std::string_view text) {
  if (!quiet_) say("36", "note:", text);
}

void Terminal::warning(std::string_view text) { say("33", "warning:", text); }

void Terminal::error(std::string_view text) { say("31", "error:", text); }

void Terminal::result(std::string_view text) {
  const std::scoped_lock lock{mutex_};
  clear_line();
  std::cout << text << std::flush;
}

void Terminal::progress(std::string_view what, double share) {
  if (!draws_) return;
  constexpr int kWidth = 24;
  const int done = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kWidth));
  const std::string bar = std::string(static_cast<std::size_t>(done), '#') +
                          std::string(static_cast<std::size_t>(kWidth - done), '.');
  const std::string line = "[" + bar + "] " + printable(what.substr(0, 50));
  const std::scoped_lock lock{mutex_};
  if (line == line_) return;
  std::cerr << "\r\x1b[K" << line << std::flush;
  line_ = line;
}

}  // namespace selion::cli
