// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/core/json_writer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "selion/core/format.hpp"

namespace selion {
namespace {

/// A row of the Unicode Standard's table 3-7: first bytes, how many bytes, and what the second one may be.
struct WellFormed {
  unsigned char first_low, first_high;
  std::size_t length;
  unsigned char second_low, second_high;
};

constexpr auto kWellFormed = std::to_array<WellFormed>({
    {0x00, 0x7F, 1, 0, 0},
    {0xC2, 0xDF, 2, 0x80, 0xBF},
    {0xE0, 0xE0, 3, 0xA0, 0xBF},
    {0xE1, 0xEC, 3, 0x80, 0xBF},
    {0xED, 0xED, 3, 0x80, 0x9F},
    {0xEE, 0xEF, 3, 0x80, 0xBF},
    {0xF0, 0xF0, 4, 0x90, 0xBF},
    {0xF1, 0xF3, 4, 0x80, 0xBF},
    {0xF4, 0xF4, 4, 0x80, 0x8F},
});

bool between(char character, unsigned char low, unsigned char high) {
  const auto byte = static_cast<unsigned char>(character);
  return byte >= low && byte <= high;
}

/// The length of the well-formed UTF-8 character that `text` starts with, 0 where there is none.
std::size_t utf8_length(std::string_view text) {
  const auto row = std::ranges::find_if(
      kWellFormed, [&](const WellFormed& r) { return between(text.front(), r.first_low, r.first_high); });
  if (row == kWellFormed.end() || text.size() < row->length) return 0;
  if (row->length == 1) return 1;
  const bool rest =
      std::ranges::all_of(text.substr(2, row->length - 2), [](char c) { return between(c, 0x80, 0xBF); });
  return rest && between(text[1], row->second_low, row->second_high) ? row->length : 0;
}

void append_control(std::string& out, char control) {
  constexpr std::string_view kHex = "0123456789abcdef";
  switch (control) {
    case '\n':
      out += "\\n";
      return;
    case '\r':
      out += "\\r";
      return;
    case '\t':
      out += "\\t";
      return;
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(control);
  out += "\\u00";
  out += kHex[code >> 4U];
  out += kHex[code & 15U];
}

void append_quoted(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const char first = text.front();
    if (length == 0) {
      out += "\xEF\xBF\xBD";
    } else if (static_cast<unsigned char>(first) < 0x20) {
      append_control(out, first);
    } else {
      if (first == '"' || first == '\\') out += '\\';
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  out += '"';
}

}  // namespace

void JsonWriter::new_line() {
  out_ += '\n';
  for (const Level& level : levels_) {
    if (level.spread == JsonSpread::lines) out_ += "  ";
  }
}

void JsonWriter::separate() {
  if (after_key_ || levels_.empty()) {
    after_key_ = false;
    return;
  }
  Level& level = levels_.back();
  if (!level.empty) out_ += level.spread == JsonSpread::line ? ", " : ",";
  if (level.spread == JsonSpread::lines) new_line();
  level.empty = false;
}

JsonWriter& JsonWriter::begin(char opening, char closing, JsonSpread spread) {
  separate();
  out_ += opening;
  levels_.push_back({spread, closing, true});
  return *this;
}

JsonWriter& JsonWriter::begin_object(JsonSpread spread) { return begin('{', '}', spread); }
JsonWriter& JsonWriter::begin_array(JsonSpread spread) { return begin('[', ']', spread); }

JsonWriter& JsonWriter::end() {
  assert(!levels_.empty() && !after_key_);
  const Level level = levels_.back();
  levels_.pop_back();
  if (level.spread == JsonSpread::lines && !level.empty) new_line();
  out_ += level.closing;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  assert(!levels_.empty() && levels_.back().closing == '}' && !after_key_);
  separate();
  append_quoted(out_, name);
  out_ += ": ";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::text(std::string_view value) {
  separate();
  append_quoted(out_, value);
  return *this;
}

JsonWriter& JsonWriter::whole(long long value) {
  separate();
  out_ += std::to_string(value);
  return *this;
}

JsonWriter& JsonWriter::number(double value, int decimals) {
  separate();
  append_fixed(out_, value, decimals);
  return *this;
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  out_ += json;
  return *this;
}

}  // namespace selion
