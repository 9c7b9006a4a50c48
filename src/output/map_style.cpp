// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_style.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "font.hpp"

namespace selion {
namespace {

constexpr std::array kStyles = std::to_array<MarkStyle>({
    {Mark::boundary, "boundary", "Field boundary", Stroke{kBlack, 0.7, {}}, {}},
    {Mark::headland, "headland", "Headland", Stroke{{190, 170, 120}, 0.25, {}}, Colour{244, 234, 208}},
    {Mark::headland_pass,
     "headland-passes",
     "Headland pass (working)",
     Stroke{kGreen, 0.3, {4, 0.8, 0.8, 0.8}},
     {}},
    {Mark::swath, "swaths", "Swath (working)", Stroke{kBlue, 0.3, {}}, {}},
    {Mark::swath_number, "swath-numbers", "Swath number, at its A end", {}, {}},
    {Mark::order, "order", "Place in the driving order, at the B end", {}, {}},
    {Mark::direction, "directions", "Driving direction", {}, {}},
    {Mark::undriven, "undriven", "Swath that is not driven", Stroke{kGrey, 0.25, {0.5, 0.9}}, {}},
    {Mark::cell, "cells", "Border between parts of one direction", Stroke{kGrey, 0.25, {2.5, 1}}, {}},
    {Mark::turn, "turns", "Turn, tool up", Stroke{kVermillion, 0.25, {1.1, 0.6}}, {}},
    {Mark::transfer, "transfers", "Transfer, tool up", Stroke{kPurple, 0.3, {0.35, 0.7}}, {}},
    {Mark::reverse, "reverse", "Driven in reverse", Stroke{kBlack, 0.6, {0.6, 0.6}}, {}},
    {Mark::pivot, "pivots", "Turn on the spot", {}, {}},
    {Mark::start, "start", "Start of the route", {}, {}},
    {Mark::end, "end", "End of the route", {}, {}},
    {Mark::gate, "gates", "Gate", {}, {}},
    {Mark::ab, "ab", "AB line, true compass heading", Stroke{kBlack, 0.35, {5, 1, 1, 1}}, {}},
    {Mark::hole, "holes", "Hole or obstacle: keep out", Stroke{kBlack, 0.35, {}}, kWhite},
    {Mark::small_hole, "small-holes", "Small obstacle, not to scale: keep out", {}, {}},
    {Mark::water, "water", "Water: keep out", Stroke{kBlue, 0.35, {}}, Colour{222, 239, 249}},
    {Mark::no_go, "no-go", "No-go area: keep out", Stroke{kVermillion, 0.35, {}}, kWhite},
});

PagePoint turned(PagePoint p, double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * p.x_mm - s * p.y_mm, s * p.x_mm + c * p.y_mm};
}

PageBox middle(const PageBox& box, double width_mm, double height_mm) {
  return box_around(box.centre(), width_mm, height_mm);
}

PageLine corners(const PageBox& box) {
  return {{box.left_mm, box.top_mm},
          {box.right_mm, box.top_mm},
          {box.right_mm, box.bottom_mm},
          {box.left_mm, box.bottom_mm}};
}

PagePoint centred_baseline(const PageBox& box, TextStyle style) {
  return {box.centre().x_mm, box.centre().y_mm + cap_height_mm(style) / 2};
}

}  // namespace

const MarkStyle& style_of(Mark mark) {
  const auto found =
      std::find_if(kStyles.begin(), kStyles.end(), [mark](const MarkStyle& s) { return s.mark == mark; });
  if (found == kStyles.end()) throw std::logic_error{"a mark of the map has no style"};
  return *found;
}

std::vector<PageLine> hatching(const std::vector<PageLine>& rings, double angle_deg, double spacing_mm) {
  // The page's y grows downwards, hence the sign. Lines are laid in the turned frame, where they are level.
  const double angle_rad = -angle_deg * std::numbers::pi / 180;
  double low = 1e9;
  double high = -1e9;
  std::vector<PageLine> level = rings;
  for (PageLine& ring : level)
    for (PagePoint& p : ring) {
      p = turned(p, -angle_rad);
      low = std::min(low, p.y_mm);
      high = std::max(high, p.y_mm);
    }
  std::vector<PageLine> lines;
  for (double row = std::ceil(low / spacing_mm); row * spacing_mm < high; ++row) {
    const double y = row * spacing_mm;
    std::vector<double> crossings;
    for (const PageLine& ring : level)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const PagePoint a = ring[i];
        const PagePoint b = ring[(i + 1) % ring.size()];
        if ((a.y_mm <= y) != (b.y_mm <= y))
          crossings.push_back(a.x_mm + (b.x_mm - a.x_mm) * (y - a.y_mm) / (b.y_mm - a.y_mm));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      lines.push_back({turned({crossings[i], y}, angle_rad), turned({crossings[i + 1], y}, angle_rad)});
  }
  return lines;
}

void draw_area(Drawing& page, Mark mark, const std::vector<PageLine>& rings) {
  const MarkStyle& style = style_of(mark);
  page.add(PageShape{rings, Ends::closed, style.fill, {}});
  const Stroke hatch{style.stroke ? style.stroke->colour : kBlack, 0.25, {}};
  if (mark == Mark::hole || mark == Mark::no_go)
    page.add(PageShape{hatching(rings, 45, 1.4), Ends::open, {}, hatch});
  if (mark == Mark::no_go) page.add(PageShape{hatching(rings, 135, 1.4), Ends::open, {}, hatch});
  if (mark == Mark::water) page.add(PageShape{hatching(rings, 0, 1.2), Ends::open, {}, hatch});
  if (style.stroke) page.add(PageShape{rings, Ends::closed, {}, style.stroke});
}

void draw_lines(Drawing& page, Mark mark, std::vector<PageLine> lines) {
  page.add(PageShape{std::move(lines), Ends::open, {}, style_of(mark).stroke});
}

void draw_arrowhead(Drawing& page, PagePoint at, double heading_rad, double size_mm) {
  PageLine head;
  for (const PagePoint corner : {PagePoint{0.55, 0}, {-0.45, 0.36}, {-0.25, 0}, {-0.45, -0.36}}) {
    const PagePoint p = turned(corner, -heading_rad);
    head.push_back({at.x_mm + size_mm * p.x_mm, at.y_mm + size_mm * p.y_mm});
  }
  page.add(PageShape{{head}, Ends::closed, kBlack, Stroke{kWhite, 0.15, {}}});
  page.add(PageShape{{head}, Ends::closed, kBlack, {}});
}

void draw_disc(Drawing& page, Mark mark, PagePoint at, const std::string& letters) {
  const bool start = mark == Mark::start;
  page.add(PageShape{{circle(at, kDisc_mm)}, Ends::closed, start ? kWhite : kBlack, Stroke{kBlack, 0.5, {}}});
  const TextStyle style = letters.size() > 2 ? kTinyBold : letters.size() > 1 ? kSmallBold : kHeading;
  page.add(PageText{letters,
                    {at.x_mm, at.y_mm + cap_height_mm(style) / 2},
                    style,
                    Align::centre,
                    0,
                    start ? kBlack : kWhite});
}

void draw_gate(Drawing& page, PagePoint at) {
  const PageBox post = box_around(at, 2 * kGate_mm, 2 * kGate_mm);
  page.add(PageShape{{corners(post)}, Ends::closed, kWhite, Stroke{kBlack, 0.5, {}}});
  page.add(PageShape{{{{post.left_mm, post.bottom_mm}, {post.right_mm, post.top_mm}},
                      {{post.left_mm, at.y_mm}, {post.right_mm, at.y_mm}}},
                     Ends::open,
                     {},
                     Stroke{kBlack, 0.3, {}}});
}

void draw_corner(Drawing& page, PagePoint at) {
  page.add(PageShape{{corners(box_around(at, 1.5, 1.5))}, Ends::closed, kBlack, Stroke{kWhite, 0.25, {}}});
}

void draw_small_hole(Drawing& page, PagePoint at) {
  constexpr double kRadius_mm = 1.1;
  const double arm = kRadius_mm * 0.7;
  const Stroke line{kBlack, 0.35, {}};
  page.add(PageShape{{circle(at, kRadius_mm)}, Ends::closed, kWhite, line});
  page.add(PageShape{{{{at.x_mm - arm, at.y_mm - arm}, {at.x_mm + arm, at.y_mm + arm}},
                      {{at.x_mm - arm, at.y_mm + arm}, {at.x_mm + arm, at.y_mm - arm}}},
                     Ends::open,
                     {},
                     line});
}

void draw_pivot(Drawing& page, PagePoint at) {
  page.add(PageShape{{circle(at, 0.7)}, Ends::closed, kWhite, Stroke{kVermillion, 0.3, {}}});
}

void draw_label(Drawing& page, const PageBox& box, const std::string& text, TextStyle style) {
  page.add(filled(box, kWhite));
  page.add(PageText{text, centred_baseline(box, style), style, Align::centre, 0, kBlack});
}

void draw_framed_label(Drawing& page, const PageBox& box, const std::string& text, TextStyle style) {
  PageShape frame = filled(box, kWhite);
  frame.stroke = Stroke{kBlack, 0.25, {}};
  page.add(frame);
  page.add(PageText{text, centred_baseline(box, style), style, Align::centre, 0, kBlack});
}

void draw_sample(Drawing& page, Mark mark, const PageBox& box) {
  const PagePoint centre = box.centre();
  switch (mark) {
    case Mark::swath_number:
      return draw_label(page, middle(box, 5, 3), "12", kSmallBold);
    case Mark::order:
      return draw_framed_label(page, middle(box, 5, 3), "3", kSmall);
    case Mark::direction:
      return draw_arrowhead(page, centre, 0, 2.2);
    case Mark::start:
      return draw_disc(page, mark, centre, "S");
    case Mark::end:
      return draw_disc(page, mark, centre, "E");
    case Mark::gate:
      return draw_gate(page, centre);
    case Mark::small_hole:
      return draw_small_hole(page, centre);
    case Mark::pivot:
      return draw_pivot(page, centre);
    case Mark::headland:
    case Mark::hole:
    case Mark::water:
    case Mark::no_go:
      return draw_area(page, mark, {corners(middle(box, box.width_mm(), 3))});
    default:
      draw_lines(page, mark, {{{box.left_mm, centre.y_mm}, {box.right_mm, centre.y_mm}}});
  }
  if (mark == Mark::ab)
    for (const double x : {box.left_mm + 0.75, box.right_mm - 0.75}) draw_corner(page, {x, centre.y_mm});
}

}  // namespace selion
