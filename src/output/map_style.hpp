// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "drawing.hpp"

namespace selion {

constexpr Colour kBlack{0, 0, 0};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kGrey{110, 110, 110};
// Okabe and Ito (2008): told apart by colour-blind readers; the dashes and symbols tell them apart without
// colour.
constexpr Colour kBlue{0, 114, 178};
constexpr Colour kGreen{0, 128, 96};
constexpr Colour kVermillion{213, 94, 0};
constexpr Colour kPurple{170, 80, 140};

constexpr TextStyle kTitle{15, Weight::bold};
constexpr TextStyle kHeading{8.5, Weight::bold};
constexpr TextStyle kBody{7.5, Weight::regular};
constexpr TextStyle kSmall{7, Weight::regular};
constexpr TextStyle kSmallBold{7, Weight::bold};
constexpr TextStyle kTinyBold{5.5, Weight::bold};  // what must fit into a disc

/// Every kind of thing on the map, in the order of the legend.
enum class Mark {
  boundary,
  headland,
  headland_pass,
  swath,
  swath_number,
  order,
  direction,
  undriven,
  cell,
  turn,
  transfer,
  reverse,
  pivot,
  start,
  end,
  gate,
  ab,
  hole,
  small_hole,
  water,
  no_go,
};

struct MarkStyle {
  Mark mark;
  std::string_view layer;  ///< class of its group in the SVG
  std::string_view legend;
  std::optional<Stroke> stroke;
  std::optional<Colour> fill;
};

const MarkStyle& style_of(Mark mark);

/// Lines at `angle_deg` anticlockwise from the page's right, `spacing_mm` apart, inside the rings (even-odd).
std::vector<PageLine> hatching(const std::vector<PageLine>& rings, double angle_deg, double spacing_mm);
/// An area filled, hatched and outlined as its mark wants.
void draw_area(Drawing& page, Mark mark, const std::vector<PageLine>& rings);
void draw_lines(Drawing& page, Mark mark, std::vector<PageLine> lines);

/// A filled arrowhead whose middle is `at`; `heading_rad` anticlockwise from the page's right.
void draw_arrowhead(Drawing& page, PagePoint at, double heading_rad, double size_mm);
/// "S" or "E" in a disc.
void draw_disc(Drawing& page, Mark mark, PagePoint at, const std::string& letters);
void draw_gate(Drawing& page, PagePoint at);
/// A corner of an AB line.
void draw_corner(Drawing& page, PagePoint at);
void draw_small_hole(Drawing& page, PagePoint at);
void draw_pivot(Drawing& page, PagePoint at);
/// Text in the middle of `box` on white; order numbers are framed.
void draw_label(Drawing& page, const PageBox& box, const std::string& text, TextStyle style);
void draw_framed_label(Drawing& page, const PageBox& box, const std::string& text, TextStyle style);

/// The sample of `mark` in the legend, in the middle of `box`.
void draw_sample(Drawing& page, Mark mark, const PageBox& box);

constexpr double kDisc_mm = 2.1;  ///< radius of start and end
constexpr double kGate_mm = 1.5;  ///< half of a gate's width

}  // namespace selion
