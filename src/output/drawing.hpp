// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace selion {

/// A place on the page: millimetres right of and below its upper left corner.
struct PagePoint {
  double x_mm = 0;
  double y_mm = 0;

  friend bool operator==(const PagePoint&, const PagePoint&) = default;
};
using PageLine = std::vector<PagePoint>;

struct PageBox {
  double left_mm = 0;
  double top_mm = 0;
  double right_mm = 0;
  double bottom_mm = 0;

  [[nodiscard]] double width_mm() const { return right_mm - left_mm; }
  [[nodiscard]] double height_mm() const { return bottom_mm - top_mm; }
  [[nodiscard]] PagePoint centre() const { return {(left_mm + right_mm) / 2, (top_mm + bottom_mm) / 2}; }
  friend bool operator==(const PageBox&, const PageBox&) = default;
};

PageBox box_around(PagePoint centre, double width_mm, double height_mm);
PageBox grown(const PageBox& box, double by_mm);
/// Touching boxes do not overlap.
bool overlap(const PageBox& a, const PageBox& b);
bool holds(const PageBox& outer, const PageBox& inner);
bool holds(const PageBox& box, PagePoint p);

struct Colour {
  int red = 0;
  int green = 0;
  int blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Marks and gaps in turn; all zero is a solid line.
using Dash = std::array<double, 4>;

struct Stroke {
  Colour colour;
  double width_mm = 0.25;
  Dash dash_mm{};
};

enum class Ends { open, closed };

/// Lines or rings of one style. A fill is even-odd over all of them.
struct PageShape {
  std::vector<PageLine> lines;
  Ends ends = Ends::open;
  std::optional<Colour> fill;
  std::optional<Stroke> stroke;
};

enum class Weight { regular, bold };
enum class Align { left, centre, right };

struct TextStyle {
  double size_pt = 7.5;
  Weight weight = Weight::regular;
};

/// One line of text.
struct PageText {
  std::string text;
  PagePoint at;  ///< on the baseline, where `align` says
  TextStyle style;
  Align align = Align::left;
  double turned_deg = 0;  ///< anticlockwise, about `at`
  Colour colour;
};

/// The items up to the matching LayerEnd belong to one kind of thing, and show only inside `clip`.
struct LayerStart {
  std::string name;
  std::optional<PageBox> clip;
};
struct LayerEnd {};

using PageItem = std::variant<PageShape, PageText, LayerStart, LayerEnd>;

/// A page as a list of what is drawn, back to front; both file formats are written from it.
struct Drawing {
  double width_mm = 210;
  double height_mm = 297;
  std::string title;
  std::string creator;
  std::vector<PageItem> items;

  void add(const PageShape& shape);
  void add(const PageText& text);
  void add(const LayerStart& layer);
  void add(LayerEnd end);
};

class Font;

/// Text stays text: <text> elements with the width that was measured for them. Layers become groups of that
/// class.
std::string to_svg(const Drawing& page, const Font& font);
/// Text stays text (it can be searched and copied). No clock: the creation date is left out.
std::string to_pdf(const Drawing& page, const Font& font);

PageShape filled(PageBox box, Colour fill);
PageShape outlined(PageBox box, Stroke stroke);
PageLine circle(PagePoint centre, double radius_mm);

}  // namespace selion
