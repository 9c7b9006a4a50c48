// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing.hpp"

#include <cmath>
#include <numbers>

namespace selion {
namespace {

PageLine corners(const PageBox& box) {
  return {{box.left_mm, box.top_mm},
          {box.right_mm, box.top_mm},
          {box.right_mm, box.bottom_mm},
          {box.left_mm, box.bottom_mm}};
}

}  // namespace

PageBox box_around(PagePoint centre, double width_mm, double height_mm) {
  return {centre.x_mm - width_mm / 2, centre.y_mm - height_mm / 2, centre.x_mm + width_mm / 2,
          centre.y_mm + height_mm / 2};
}

PageBox grown(const PageBox& box, double by_mm) {
  return {box.left_mm - by_mm, box.top_mm - by_mm, box.right_mm + by_mm, box.bottom_mm + by_mm};
}

bool overlap(const PageBox& a, const PageBox& b) {
  return a.left_mm < b.right_mm && b.left_mm < a.right_mm && a.top_mm < b.bottom_mm && b.top_mm < a.bottom_mm;
}

bool holds(const PageBox& outer, const PageBox& inner) {
  return outer.left_mm <= inner.left_mm && outer.top_mm <= inner.top_mm && outer.right_mm >= inner.right_mm &&
         outer.bottom_mm >= inner.bottom_mm;
}

bool holds(const PageBox& box, PagePoint p) { return holds(box, PageBox{p.x_mm, p.y_mm, p.x_mm, p.y_mm}); }

void Drawing::add(const PageShape& shape) { items.emplace_back(shape); }
void Drawing::add(const PageText& text) { items.emplace_back(text); }
void Drawing::add(const LayerStart& layer) { items.emplace_back(layer); }
void Drawing::add(LayerEnd end) { items.emplace_back(end); }

PageShape filled(PageBox box, Colour fill) { return {{corners(box)}, Ends::closed, fill, {}}; }
PageShape outlined(PageBox box, Stroke stroke) { return {{corners(box)}, Ends::closed, {}, stroke}; }

PageLine circle(PagePoint centre, double radius_mm) {
  constexpr int kCorners = 32;
  PageLine ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle_rad = 2 * std::numbers::pi * i / kCorners;
    ring.push_back(
        {centre.x_mm + radius_mm * std::cos(angle_rad), centre.y_mm + radius_mm * std::sin(angle_rad)});
  }
  return ring;
}

}  // namespace selion
