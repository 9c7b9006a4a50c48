// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "map_sheet.hpp"

namespace selion {
namespace {

enum class SwathEnd { a, b };

struct NumberStyle {
  Mark mark;
  TextStyle text;
  SwathEnd at;
};
constexpr NumberStyle kNumber{Mark::swath_number, kSmallBold, SwathEnd::a};
constexpr NumberStyle kOrder{Mark::order, kSmall, SwathEnd::b};

constexpr std::array kSteps{1, 2, 5, 10, 20, 25, 50, 100, 125, 200, 250, 500, 1000, 5000, 10000};

struct Size {
  double width_mm = 0;
  double height_mm = 0;
};

Size label_size(const Font& font, const std::string& text, TextStyle style) {
  return {font.width_mm(text, style) + 0.9, cap_height_mm(style) + 1};
}

/// How far a box's middle must stand off a line's end so that the box begins there.
double half_along(Size size, double heading_rad) {
  const double c = std::abs(std::cos(heading_rad));
  const double s = std::abs(std::sin(heading_rad));
  return std::min(c > 1e-6 ? size.width_mm / 2 / c : 1e9, s > 1e-6 ? size.height_mm / 2 / s : 1e9);
}

/// The least step at which the numbers of neighbouring swaths clear each other.
int clear_step(const MapSheet& sheet, int block, Size size) {
  const SwathRecord* longest = nullptr;
  for (const SwathRecord& swath : sheet.plan.swaths)
    if (swath.block == block && swath.line.size() > 1 &&
        (longest == nullptr || swath.length_m > longest->length_m))
      longest = &swath;
  if (longest == nullptr) return 1;
  const PageLine line = sheet.view.at(longest->line);
  const double apart_mm = longest->width_m * sheet.view.mm_per_m;
  const double across_rad = place_on(line, length_mm(line) / 2).heading_rad + std::numbers::pi / 2;
  const double needed = 2 * half_along(size, across_rad) / std::max(apart_mm, 1e-6);
  const int drawn = drawn_step(sheet.plan, sheet.view);
  for (const int step : kSteps)
    if (step % drawn == 0 && step >= needed) return step;
  return kSteps.back();
}

/// Places for a number on its swath: at the end where it belongs, then further in.
std::vector<PageBox> places_on(PageLine line, SwathEnd end, Size size) {
  if (end == SwathEnd::b) std::reverse(line.begin(), line.end());
  const double length = length_mm(line);
  const double half = half_along(size, place_on(line, 0).heading_rad) + 0.4;
  std::vector<PageBox> boxes;
  for (int i = 0; i < 8; ++i) {
    const double from_start = half + i * half / 2;
    if (from_start + half > length * 0.55) break;
    boxes.push_back(box_around(place_on(line, from_start).at, size.width_mm, size.height_mm));
  }
  return boxes;
}

bool place_number(MapSheet& sheet, const SwathRecord& swath, const NumberStyle& style,
                  const std::string& text, bool must) {
  if (swath.line.size() < 2) return false;
  const Size size = label_size(sheet.font, text, style.text);
  const PageLine line = sheet.view.at(swath.line);
  std::vector<PageBox> candidates = places_on(line, style.at, size);
  if (candidates.empty() && style.at == SwathEnd::a)
    candidates.push_back(box_around(place_on(line, length_mm(line) / 2).at, size.width_mm, size.height_mm));
  if (must) {
    const PagePoint end = style.at == SwathEnd::a ? line.front() : line.back();
    const std::vector<PageBox> beside = boxes_near(end, size.width_mm, size.height_mm, 0.5, 12);
    candidates.insert(candidates.end(), beside.begin(), beside.end());
  }
  const auto place = sheet.placer.place(candidates);
  if (!place) return false;
  if (style.mark == Mark::order)
    draw_framed_label(sheet.page, *place, text, style.text);
  else
    draw_label(sheet.page, *place, text, style.text);
  return true;
}

/// Swaths in the order in which they may claim room: the first and last, then round numbers, then pockets.
std::vector<const SwathRecord*> by_claim(const PlanFile& plan, int block, StripRange strips, int step) {
  std::vector<const SwathRecord*> ends;
  std::vector<const SwathRecord*> between;
  std::vector<const SwathRecord*> pockets;
  for (const SwathRecord& swath : plan.swaths) {
    const int number = strip_number(swath.id);
    if (swath.block != block) continue;
    if (number == 0)
      pockets.push_back(&swath);
    else if (number == strips.first || number == strips.last)
      ends.push_back(&swath);
    else if (number % step == 0)
      between.push_back(&swath);
  }
  ends.insert(ends.end(), between.begin(), between.end());
  ends.insert(ends.end(), pockets.begin(), pockets.end());
  return ends;
}

/// Swath numbers and places in the order stand on the same swaths, so that a reader can pair them.
int number_step(const MapSheet& sheet, int block, StripRange strips) {
  const std::string longest = std::to_string(std::max(strips.last, 10)) + 'a';
  return clear_step(sheet, block, label_size(sheet.font, longest, kNumber.text));
}

void number_swaths(MapSheet& sheet, const NumberStyle& style,
                   const std::function<std::string(const SwathRecord&)>& words) {
  in_layer(sheet, style.mark, [&] {
    for (const auto& [block, strips] : strips_by_block(sheet.plan))
      for (const SwathRecord* swath :
           by_claim(sheet.plan, block, strips, number_step(sheet, block, strips))) {
        const int number = strip_number(swath->id);
        const bool must = style.mark == Mark::swath_number && number != 0 &&
                          (number == strips.first || number == strips.last);
        if (const std::string text = words(*swath); !text.empty())
          place_number(sheet, *swath, style, text, must);
      }
  });
}

std::string numbered_words(const MapSheet& sheet) {
  int step = 1;
  int last = 0;
  for (const auto& [block, strips] : strips_by_block(sheet.plan)) {
    step = std::max(step, number_step(sheet, block, strips));
    last = std::max(last, strips.last);
  }
  if (step == 1) return "";
  if (2 * step >= last) return " (of some)";
  return ": 1, " + std::to_string(step) + ", " + std::to_string(2 * step) + " \u2026 and the last";
}

bool place_arrow(MapSheet& sheet, const PageLine& line, const std::vector<double>& from_start_mm) {
  constexpr double kSize_mm = 2;
  for (const double from_start : from_start_mm) {
    const PlaceOnLine place = place_on(line, from_start);
    if (!sheet.placer.place({box_around(place.at, kSize_mm, kSize_mm)})) continue;
    draw_arrowhead(sheet.page, place.at, place.heading_rad, kSize_mm);
    return true;
  }
  return false;
}

void arrows_along(MapSheet& sheet, const DrawnTrack& track, double apart_mm, double first_mm) {
  const double length = length_mm(track.line);
  const int arrows = static_cast<int>(std::ceil((length - 3 - first_mm) / apart_mm));
  for (int i = 0; i < arrows; ++i) {
    const double s = first_mm + i * apart_mm;
    place_arrow(sheet, track.line, {s, s + 2.5, s - 2.5, s + 5});
  }
}

/// An odd step, so that neighbours which are driven up and down keep showing both.
int arrow_step(const MapSheet& sheet) {
  constexpr double kApart_mm = 3.2;
  double width_m = 1e9;
  for (const SwathRecord& swath : sheet.plan.swaths) width_m = std::min(width_m, swath.width_m);
  int step = drawn_step(sheet.plan, sheet.view);
  const int more = step;
  while (step * width_m * sheet.view.mm_per_m < kApart_mm && step < 10000) step += 2 * more;
  return step;
}

}  // namespace

void draw_numbers(MapSheet& sheet) {
  number_swaths(sheet, kNumber, [](const SwathRecord& swath) { return swath.id; });
  if (sheet.drawn.contains(Mark::swath_number)) sheet.drawn[Mark::swath_number] += numbered_words(sheet);
}

void draw_order(MapSheet& sheet) {
  int last = 0;
  for (const SwathRecord& swath : sheet.plan.swaths) last = std::max(last, swath.order);
  number_swaths(sheet, kOrder,
                [](const SwathRecord& swath) { return swath.order > 0 ? std::to_string(swath.order) : ""; });
  if (sheet.drawn.contains(Mark::order))
    sheet.drawn[Mark::order] = "Place in the driving order (1 to " + std::to_string(last) + "), at the B end";
}

void draw_directions(MapSheet& sheet) {
  const int step = arrow_step(sheet);
  in_layer(sheet, Mark::direction, [&] {
    for (const DrawnTrack& track : sheet.tracks) {
      const double length = length_mm(track.line);
      const int number = strip_number(track.ref);
      if (track.mark == Mark::swath && number % step == 0 && length > 6)
        place_arrow(sheet, track.line,
                    {0.5 * length, 0.45 * length, 0.55 * length, 0.4 * length, 0.6 * length});
      if (track.mark == Mark::headland_pass && length > 12 && sheet.drawn.contains(Mark::headland_pass))
        arrows_along(sheet, track, 45, 8);
      if ((track.mark == Mark::transfer || track.mark == Mark::reverse) && length > 10)
        arrows_along(sheet, track, 40, length / 2);
    }
  });
}

}  // namespace selion
