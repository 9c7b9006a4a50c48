// SPDX-License-Identifier: GPL-3.0-or-later
#include "font.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include <pango/pangocairo.h>

#if defined(__has_feature)  // clang's way to ask
#if __has_feature(address_sanitizer)
#define SELION_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define SELION_ADDRESS_SANITIZER
#endif
#ifdef SELION_ADDRESS_SANITIZER
// fontconfig 2.14 loses 288 bytes once, where it reads its own configuration; a check for leaks of ours must
// not end there.
extern "C" __attribute__((weak, visibility("default"))) const char*
__lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier): the sanitizer's own name
  return "leak:libfontconfig.so\n";
}
#endif

namespace selion {
namespace {

constexpr double kMmPerPt = 25.4 / 72;
constexpr const char* kEllipsis = "\u2026";

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
using Layout = std::unique_ptr<PangoLayout, Unref>;

std::size_t next_letter(const std::string& text, std::size_t at) {
  do ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U);
  return at;
}

/// The words with one space between them.
std::string spaced_once(const std::string& text) {
  std::string words;
  for (const char c : text)
    if (c != ' ' || (!words.empty() && words.back() != ' ')) words += c;
  if (words.ends_with(' ')) words.pop_back();
  return words;
}

}  // namespace

struct Font::Setting {
  std::unique_ptr<PangoFontMap, Unref> fonts{pango_cairo_font_map_new()};
  std::unique_ptr<PangoContext, Unref> context{pango_font_map_create_context(fonts.get())};

  Setting() {
    pango_cairo_context_set_resolution(context.get(), 72);
    pango_context_set_language(context.get(), pango_language_from_string("en"));
    pango_context_set_round_glyph_positions(context.get(), FALSE);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context.get(), options);
    cairo_font_options_destroy(options);
  }

  [[nodiscard]] Layout layout(const std::string& text, TextStyle style) const {
    Layout made{pango_layout_new(context.get())};
    PangoFontDescription* font = pango_font_description_new();
    pango_font_description_set_family_static(font, "DejaVu Sans");
    pango_font_description_set_weight(font,
                                      style.weight == Weight::bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_font_description_set_size(font, static_cast<int>(style.size_pt * PANGO_SCALE));
    pango_layout_set_font_description(made.get(), font);
    pango_font_description_free(font);
    pango_layout_set_single_paragraph_mode(made.get(), TRUE);
    pango_layout_set_text(made.get(), text.data(), static_cast<int>(text.size()));
    return made;
  }

  static double width_mm(const Layout& layout) {
    int width = 0;
    pango_layout_get_size(layout.get(), &width, nullptr);
    return kMmPerPt * width / PANGO_SCALE;
  }

  /// How far the text before each byte reaches in Pango's units, at last all of it. Absent where letters run
  /// from right to left: there a part may be set otherwise than within the whole.
  [[nodiscard]] std::optional<std::vector<int>> reaches(const std::string& text, TextStyle style) const {
    const Layout whole = layout(text, style);
    std::vector<int> reach(text.size() + 1, 0);
    for (GSList* run = pango_layout_get_line_readonly(whole.get(), 0)->runs; run != nullptr;
         run = run->next) {
      const auto& [item, glyphs, y_offset, start, end] = *static_cast<const PangoGlyphItem*>(run->data);
      if (item->analysis.level % 2 != 0) return std::nullopt;
      for (int i = 0; i < glyphs->num_glyphs; ++i)
        reach[static_cast<std::size_t>(item->offset + glyphs->log_clusters[i]) + 1] +=
            glyphs->glyphs[i].geometry.width;
    }
    std::partial_sum(reach.begin(), reach.end(), reach.begin());
    return reach;
  }
};

Font::Font() : setting_{std::make_unique<Setting>()} {}
Font::~Font() = default;

double Font::width_mm(const std::string& text, TextStyle style) const {
  return Setting::width_mm(setting_->layout(printable(text), style));
}

std::size_t Font::fitting_letters(const std::string& word, TextStyle style, double width_mm) const {
  if (this->width_mm(word, style) <= width_mm) return word.size();
  std::size_t cut = next_letter(word, 0);
  while (cut < word.size() && this->width_mm(word.substr(0, next_letter(word, cut)), style) <= width_mm)
    cut = next_letter(word, cut);
  return cut;
}

std::vector<std::string> Font::wrapped(const std::string& text, TextStyle style, double width_mm) const {
  const std::string words = spaced_once(printable(text));
  // All at once, for setting it is what takes time.
  const auto reach = setting_->reaches(words, style);
  const auto fits = [&](std::size_t from, std::size_t to) {
    return (reach ? kMmPerPt * ((*reach)[to] - (*reach)[from]) / PANGO_SCALE
                  : this->width_mm(words.substr(from, to - from), style)) <= width_mm;
  };
  std::vector<std::string> lines;
  std::size_t line = 0;  // where it begins, and
  std::size_t end = 0;   // where it ends so far
  for (std::size_t word = 0; word < words.size(); word = end + 1) {
    const std::size_t word_end = std::min(words.find(' ', word), words.size());
    if (!fits(line, word_end) && end > line) {
      lines.push_back(words.substr(line, end - line));
      line = word;
    }
    while (!fits(line, word_end)) {
      const std::string rest = words.substr(line, word_end - line);
      const std::size_t cut = fitting_letters(rest, style, width_mm);
      if (cut == rest.size()) break;
      lines.push_back(rest.substr(0, cut));
      line += cut;
    }
    end = word_end;
  }
  lines.push_back(words.substr(line));
  return lines;
}

std::string Font::shortened(const std::string& text, TextStyle style, double width_mm) const {
  std::string whole = printable(text);
  if (this->width_mm(whole, style) <= width_mm) return whole;
  std::string best = kEllipsis;
  for (std::size_t cut = next_letter(whole, 0); cut < whole.size(); cut = next_letter(whole, cut)) {
    const std::string part = whole.substr(0, cut) + kEllipsis;
    if (this->width_mm(part, style) > width_mm) break;
    best = part;
  }
  return best;
}

void Font::draw(_cairo* page, const PageText& text) const {
  const Layout layout = setting_->layout(printable(text.text), text.style);
  const double width_pt = Setting::width_mm(layout) / kMmPerPt;
  const double before_pt = text.align == Align::left    ? 0
                           : text.align == Align::right ? width_pt
                                                        : width_pt / 2;
  cairo_save(page);
  cairo_set_source_rgb(page, text.colour.red / 255.0, text.colour.green / 255.0, text.colour.blue / 255.0);
  cairo_translate(page, text.at.x_mm, text.at.y_mm);
  cairo_rotate(page, -text.turned_deg * G_PI / 180);
  cairo_scale(page, kMmPerPt, kMmPerPt);
  cairo_move_to(page, -before_pt, 0);
  pango_cairo_show_layout_line(page, pango_layout_get_line_readonly(layout.get(), 0));
  cairo_restore(page);
}

double cap_height_mm(TextStyle style) { return 0.73 * style.size_pt * kMmPerPt; }
double line_height_mm(TextStyle style) { return 1.22 * style.size_pt * kMmPerPt; }

std::string printable(const std::string& text) {
  gchar* valid = g_utf8_make_valid(text.data(), static_cast<gssize>(text.size()));
  std::string clean;
  for (const gchar* at = valid; *at != '\0'; at = g_utf8_next_char(at)) {
    const gunichar letter = g_utf8_get_char(at);
    const bool control =
        letter < 0x20 || (letter >= 0x7F && letter < 0xA0) || letter == 0xFFFE || letter == 0xFFFF;
    const bool turns_text = (letter >= 0x202A && letter <= 0x202E) || (letter >= 0x2066 && letter <= 0x2069);
    if (control || turns_text)
      clean += ' ';
    else
      clean.append(at, static_cast<std::size_t>(g_utf8_next_char(at) - at));
  }
  g_free(valid);
  return clean;
}

}  // namespace selion
