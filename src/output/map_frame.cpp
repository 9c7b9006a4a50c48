// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "map_sheet.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"

namespace selion {
namespace {

constexpr Stroke kTick{kBlack, 0.25, {}};
constexpr Stroke kHairline{kGrey, 0.1, {}};

/// 1, 2 or 5 times a power of ten.
double nice_at_least(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= value * (1 - 1e-9)) return digit * power;
  return 10 * power;
}

struct Steps {
  double step_deg = 1;
  int decimals = 0;
};

Steps steps_for(double apart_deg) {
  const double step_deg = std::clamp(nice_at_least(apart_deg), 1e-7, 10.0);
  return {step_deg, std::max(0, static_cast<int>(std::ceil(-std::log10(step_deg) - 1e-9)))};
}

std::string degrees(double deg, int decimals, const char* positive, const char* negative) {
  return fixed(std::abs(deg), decimals) + "\u00B0 " + (deg < 0 ? negative : positive);
}

/// Where along an edge (0 to 1) `value`, which runs steadily along it, reaches the multiples of `step`.
struct Tick {
  double share = 0;
  double value_deg = 0;
};
std::vector<Tick> ticks_on(const std::function<double(double)>& value, double step) {
  const double from = value(0);
  const double to = value(1);
  const bool rising = to > from;
  std::vector<Tick> ticks;
  for (double k = std::ceil(std::min(from, to) / step); k * step <= std::max(from, to) && ticks.size() < 50;
       ++k) {
    double low = 0;
    double high = 1;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      ((value(middle) < k * step) == rising ? low : high) = middle;
    }
    ticks.push_back({(low + high) / 2, k * step});
  }
  return ticks;
}

/// Longitude without a jump where the map lies on the antimeridian.
double unwrapped(double lon_deg, double near_deg) {
  return lon_deg + 360 * std::round((near_deg - lon_deg) / 360);
}
double wrapped_deg(double lon_deg) {
  return lon_deg > 180 ? lon_deg - 360 : lon_deg < -180 ? lon_deg + 360 : lon_deg;
}

class Graticule {
 public:
  Graticule(Drawing& page, const MapView& view, const Font& font) : page_{page}, view_{view}, font_{font} {
    const PageBox& f = view.frame;
    middle_ = view.lonlat(f.centre());
    const double room_mm = font.width_mm("179.00000\u00B0 W", kSmall) + 8;
    lon_ = steps_for(std::abs(lon_at({f.right_mm, f.bottom_mm}) - lon_at({f.left_mm, f.bottom_mm})) *
                     room_mm / f.width_mm());
    lat_ = steps_for(std::abs(lat_at({f.left_mm, f.top_mm}) - lat_at({f.left_mm, f.bottom_mm})) * room_mm /
                     f.height_mm());
  }

  void draw() {
    const PageBox& f = view_.frame;
    const std::vector<Tick> south = meridians(f.bottom_mm);
    const std::vector<Tick> west = parallels(f.left_mm);
    std::vector<PageLine> ticks;
    ticks.reserve(2 * (south.size() + west.size()) + 4);
    for (const Tick& t : south) ticks.push_back(down(f.left_mm + t.share * f.width_mm(), f.bottom_mm, 1.5));
    for (const Tick& t : meridians(f.top_mm))
      ticks.push_back(down(f.left_mm + t.share * f.width_mm(), f.top_mm - 1.5, 1.5));
    for (const Tick& t : west)
      ticks.push_back(across(f.left_mm - 1.5, f.bottom_mm - t.share * f.height_mm()));
    for (const Tick& t : parallels(f.right_mm))
      ticks.push_back(across(f.right_mm, f.bottom_mm - t.share * f.height_mm()));
    crosses(south, west);
    page_.add(outlined(f, Stroke{kBlack, 0.35, {}}));
    page_.add(PageShape{ticks, Ends::open, {}, kTick});
    for (const Tick& t : south)
      number(degrees(wrapped_deg(t.value_deg), lon_.decimals, "E", "W"),
             {f.left_mm + t.share * f.width_mm(), f.bottom_mm + 4.2}, 0);
    for (const Tick& t : west)
      number(degrees(t.value_deg, lat_.decimals, "N", "S"),
             {f.left_mm - 2.2, f.bottom_mm - t.share * f.height_mm()}, 90);
  }

 private:
  [[nodiscard]] double lon_at(PagePoint p) const {
    return unwrapped(view_.lonlat(p).lon_deg, middle_.lon_deg);
  }
  [[nodiscard]] double lat_at(PagePoint p) const { return view_.lonlat(p).lat_deg; }

  [[nodiscard]] std::vector<Tick> meridians(double y_mm) const {
    const PageBox& f = view_.frame;
    return ticks_on(
        [&](double share) {
          return lon_at({f.left_mm + share * f.width_mm(), y_mm});
        },
        lon_.step_deg);
  }
  [[nodiscard]] std::vector<Tick> parallels(double x_mm) const {
    const PageBox& f = view_.frame;
    return ticks_on(
        [&](double share) {
          return lat_at({x_mm, f.bottom_mm - share * f.height_mm()});
        },
        lat_.step_deg);
  }

  static PageLine down(double x_mm, double y_mm, double length_mm) {
    return {{x_mm, y_mm}, {x_mm, y_mm + length_mm}};
  }
  static PageLine across(double x_mm, double y_mm) { return {{x_mm, y_mm}, {x_mm + 1.5, y_mm}}; }

  void crosses(const std::vector<Tick>& lons, const std::vector<Tick>& lats) {
    std::vector<PageLine> lines;
    for (const Tick& lon : lons)
      for (const Tick& lat : lats) {
        const PagePoint at = view_.at(LonLat{wrapped_deg(lon.value_deg), lat.value_deg});
        if (!holds(grown(view_.frame, -3), at)) continue;
        lines.push_back({{at.x_mm - 2, at.y_mm}, {at.x_mm + 2, at.y_mm}});
        lines.push_back({{at.x_mm, at.y_mm - 2}, {at.x_mm, at.y_mm + 2}});
      }
    if (!lines.empty()) page_.add(PageShape{lines, Ends::open, {}, kHairline});
  }

  /// Kept within the length of its side, so that none runs over a corner of the frame.
  void number(const std::string& text, PagePoint at, double turned_deg) {
    const PageBox& f = view_.frame;
    const double half = font_.width_mm(text, kSmall) / 2;
    if (turned_deg == 0)
      at.x_mm = std::clamp(at.x_mm, f.left_mm + half, std::max(f.left_mm + half, f.right_mm - half));
    else
      at.y_mm = std::clamp(at.y_mm, f.top_mm + half, std::max(f.top_mm + half, f.bottom_mm - half));
    page_.add(PageText{text, at, kSmall, Align::centre, turned_deg, kBlack});
  }

  Drawing& page_;
  const MapView& view_;
  const Font& font_;
  LonLat middle_;
  Steps lon_;
  Steps lat_;
};

struct LengthUnit {
  double metres;
  std::string name;
};

/// One bar of four fields with its numbers above.
double draw_bar(Drawing& page, const MapView& view, PagePoint at, double room_mm, const LengthUnit& unit) {
  const double mm_per_unit = view.mm_per_m * unit.metres;
  double whole = nice_at_least(room_mm / mm_per_unit);
  while (whole * mm_per_unit > room_mm) whole = nice_at_least(whole / 2.6);
  const double length = whole * mm_per_unit;
  for (int i = 0; i < 4; ++i) {
    const PageBox part{at.x_mm + i * length / 4, at.y_mm, at.x_mm + (i + 1) * length / 4, at.y_mm + 1.3};
    PageShape shape = filled(part, i % 2 == 0 ? kBlack : kWhite);
    shape.stroke = kTick;
    page.add(shape);
  }
  const auto words = [](double value) {
    if (value >= 10 || value == std::floor(value)) return fixed(value, 0);
    return fixed(value, value >= 0.5 ? 1 : 2);
  };
  page.add(PageText{"0", {at.x_mm, at.y_mm - 0.8}, kSmall, Align::left, 0, kBlack});
  page.add(
      PageText{words(whole / 2), {at.x_mm + length / 2, at.y_mm - 0.8}, kSmall, Align::centre, 0, kBlack});
  page.add(PageText{
      words(whole) + ' ' + unit.name, {at.x_mm + length, at.y_mm - 0.8}, kSmall, Align::centre, 0, kBlack});
  return length;
}

std::string grouped(double whole) {
  std::string digits = fixed(whole, 0);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, "\u202F");
  return digits;
}

void draw_north_arrow(Drawing& page, PagePoint at, double true_north_rad) {
  const auto turned = [&](double x, double y) {
    const double c = std::cos(true_north_rad);
    const double s = std::sin(true_north_rad);
    return PagePoint{at.x_mm + c * x - s * y, at.y_mm + s * x + c * y};
  };
  const PagePoint tip = turned(0, -4);
  const PagePoint waist = turned(0, 2.2);
  page.add(PageShape{
      {{tip, turned(2.2, 4), waist, turned(-2.2, 4)}}, Ends::closed, kWhite, Stroke{kBlack, 0.3, {}}});
  page.add(PageShape{{{tip, waist, turned(-2.2, 4)}}, Ends::closed, kBlack, Stroke{kBlack, 0.3, {}}});
  const PagePoint letter = turned(0, -6);
  page.add(PageText{
      "N", {letter.x_mm, letter.y_mm + cap_height_mm(kHeading) / 2}, kHeading, Align::centre, 0, kBlack});
}

std::string north_words(double convergence_deg) {
  if (std::abs(convergence_deg) <= 0.1) return "true north";
  return "true north; up is " + fixed(std::abs(convergence_deg), 2) + "\u00B0 " +
         (convergence_deg > 0 ? "east" : "west") + " of it";
}

}  // namespace

void draw_graticule(Drawing& page, const MapView& view, const Font& font) {
  page.add(LayerStart{"frame", {}});
  Graticule{page, view, font}.draw();
  page.add(LayerEnd{});
}

void draw_scale_and_north(Drawing& page, const MapView& view, const Font& font, PageBox box, Units units) {
  page.add(LayerStart{"scale", {}});
  const double room_mm = std::min(60.0, box.width_mm() * 0.34);
  const PagePoint first{box.left_mm + 1, box.top_mm + 4};
  const PagePoint second{box.left_mm + 1, box.top_mm + 10.5};
  const LengthUnit metre{1, "m"};
  const LengthUnit foot{0.3048, "ft"};
  const bool metric = units == Units::metric;
  const double longer = std::max(draw_bar(page, view, first, room_mm, metric ? metre : foot),
                                 draw_bar(page, view, second, room_mm, metric ? foot : metre));
  const double x = first.x_mm + longer + 14;
  page.add(PageText{"Scale 1 : " + grouped(std::round(1000 / view.mm_per_m)),
                    {x, box.top_mm + 5.2},
                    kHeading,
                    Align::left,
                    0,
                    kBlack});
  page.add(PageText{"printed at 100 %", {x, box.top_mm + 9}, kSmall, Align::left, 0, kBlack});

  const double convergence_deg = view.plane.convergence_deg(view.centre);
  const std::vector<std::string> words = font.wrapped(north_words(convergence_deg), kSmall, 34);
  const PagePoint arrow{box.right_mm - 5, box.top_mm + 8.2};
  draw_north_arrow(page, arrow, radians_of_degrees(-convergence_deg));
  double y = box.top_mm + 8.5 - line_height_mm(kSmall) * (static_cast<double>(words.size()) - 1) / 2;
  for (const std::string& line : words) {
    page.add(PageText{line, {arrow.x_mm - 5, y}, kSmall, Align::right, 0, kBlack});
    y += line_height_mm(kSmall);
  }
  page.add(LayerEnd{});
}

}  // namespace selion
