// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drawing.hpp"

struct _cairo;  // NOLINT(bugprone-reserved-identifier): Cairo's own name, so that its header stays out of
                // here

namespace selion {

/// DejaVu Sans as Pango sets it, unhinted: the same widths for both file formats. One per thread.
class Font {
 public:
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;
  Font(Font&&) = delete;
  Font& operator=(Font&&) = delete;

  [[nodiscard]] double width_mm(const std::string& text, TextStyle style) const;
  /// Broken at spaces into lines no wider than `width_mm`, a longer word between letters. At least one line.
  [[nodiscard]] std::vector<std::string> wrapped(const std::string& text, TextStyle style,
                                                 double width_mm) const;
  /// `text`, or as much of its start as fits with an ellipsis.
  [[nodiscard]] std::string shortened(const std::string& text, TextStyle style, double width_mm) const;
  /// On a Cairo context whose unit is a millimetre.
  void draw(_cairo* page, const PageText& text) const;

 private:
  /// Bytes of the longest start of `word` that fits, at least one letter.
  [[nodiscard]] std::size_t fitting_letters(const std::string& word, TextStyle style, double width_mm) const;

  struct Setting;
  std::unique_ptr<Setting> setting_;
};

/// Height of a capital letter and from line to line.
double cap_height_mm(TextStyle style);
double line_height_mm(TextStyle style);

/// `text` as valid UTF-8 without control characters, which neither XML nor Pango take, nor marks that turn
/// the direction of text, by which names could hide what follows them.
std::string printable(const std::string& text);

}  // namespace selion
