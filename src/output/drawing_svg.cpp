// SPDX-License-Identifier: GPL-3.0-or-later
#include <string_view>

#include "drawing.hpp"
#include "font.hpp"
#include "selion/core/format.hpp"

namespace selion {
namespace {

constexpr double kMmPerPt = 25.4 / 72;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : printable(text)) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

/// To a hundredth of a millimetre, without the zeros at the end: the file of a large field is half paths.
std::string number(double value) {
  std::string digits = fixed(value, 2);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

std::string hex(Colour colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const int part : {colour.red, colour.green, colour.blue}) {
    out += kDigits[static_cast<std::size_t>(part) / 16];
    out += kDigits[static_cast<std::size_t>(part) % 16];
  }
  return out;
}

class Writer {
 public:
  explicit Writer(const Font& font) : font_{font} {}

  std::string page(const Drawing& page) {
    const std::string width = number(page.width_mm);
    const std::string height = number(page.height_mm);
    out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
           width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + ' ' + height +
           "\" font-family=\"'DejaVu Sans', Verdana, sans-serif\" stroke-linejoin=\"round\">\n<title>" +
           escaped(page.title) + "</title>\n<desc>" + escaped(page.creator) + "</desc>\n<rect width=\"" +
           width + "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n";
    for (const PageItem& item : page.items) std::visit([this](const auto& it) { add(it); }, item);
    return out_ + "</svg>\n";
  }

 private:
  void add(const PageShape& shape) {
    out_ += "<path d=\"";
    for (const PageLine& line : shape.lines) {
      char before = 'M';
      for (const PagePoint p : line) {
        out_ += before + number(p.x_mm) + ',' + number(p.y_mm);
        before = ' ';
      }
      if (shape.ends == Ends::closed) out_ += 'Z';
    }
    out_ += "\" fill=\"" + (shape.fill ? hex(*shape.fill) : "none") + '"';
    if (shape.fill && shape.lines.size() > 1) out_ += " fill-rule=\"evenodd\"";
    if (shape.stroke) add(*shape.stroke);
    out_ += "/>\n";
  }

  void add(const Stroke& stroke) {
    out_ += " stroke=\"" + hex(stroke.colour) + "\" stroke-width=\"" + number(stroke.width_mm) + '"';
    if (stroke.dash_mm[0] <= 0) return;
    out_ += " stroke-dasharray=\"" + number(stroke.dash_mm[0]);
    for (std::size_t i = 1; i < stroke.dash_mm.size() && stroke.dash_mm[i] > 0; ++i)
      out_ += ' ' + number(stroke.dash_mm[i]);
    out_ += '"';
  }

  void add(const PageText& text) {
    const std::string x = number(text.at.x_mm);
    const std::string y = number(text.at.y_mm);
    out_ += "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + fixed(text.style.size_pt * kMmPerPt, 3) +
            "\" textLength=\"" + number(font_.width_mm(text.text, text.style)) +
            R"(" lengthAdjust="spacingAndGlyphs")";
    if (text.style.weight == Weight::bold) out_ += " font-weight=\"bold\"";
    if (text.align != Align::left)
      out_ += std::string{" text-anchor=\""} + (text.align == Align::right ? "end" : "middle") + '"';
    if (text.turned_deg != 0)
      out_ += " transform=\"rotate(" + number(-text.turned_deg) + ' ' + x + ' ' + y + ")\"";
    if (text.colour != Colour{}) out_ += " fill=\"" + hex(text.colour) + '"';
    out_ += '>' + escaped(text.text) + "</text>\n";
  }

  void add(const LayerStart& layer) {
    if (layer.clip) {
      const std::string id = "clip" + std::to_string(++clips_);
      out_ += "<clipPath id=\"" + id + "\"><rect x=\"" + number(layer.clip->left_mm) + "\" y=\"" +
              number(layer.clip->top_mm) + "\" width=\"" + number(layer.clip->width_mm()) + "\" height=\"" +
              number(layer.clip->height_mm()) + "\"/></clipPath>\n<g class=\"" + layer.name +
              "\" clip-path=\"url(#" + id + ")\">\n";
    } else {
      out_ += "<g class=\"" + layer.name + "\">\n";
    }
  }

  void add(const LayerEnd& /*end*/) { out_ += "</g>\n"; }

  const Font& font_;
  std::string out_;
  int clips_ = 0;
};

}  // namespace

std::string to_svg(const Drawing& page, const Font& font) { return Writer{font}.page(page); }

}  // namespace selion
