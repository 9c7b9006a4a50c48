// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_placer.hpp"

#include <algorithm>
#include <array>

namespace selion {

bool LabelPlacer::is_free(const PageBox& box) const {
  return holds(room_, box) && std::none_of(taken_.begin(), taken_.end(),
                                           [&](const PageBox& other) { return overlap(box, other); });
}

std::optional<PageBox> LabelPlacer::place(const std::vector<PageBox>& candidates) {
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [this](const PageBox& box) { return is_free(box); });
  if (found == candidates.end()) return std::nullopt;
  take(*found);
  return *found;
}

std::vector<PageBox> boxes_near(PagePoint at, double width_mm, double height_mm, double gap_mm,
                                double reach_mm) {
  // Right first, as a reader expects a name there; then clockwise about the place.
  constexpr std::array<PagePoint, 8> kSides{
      {{1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}}};
  std::vector<PageBox> boxes;
  const double step_mm = std::max(1.0, height_mm / 2);
  for (int ring = 0; gap_mm + ring * step_mm <= reach_mm; ++ring)
    for (const PagePoint side : kSides) {
      const double gap = gap_mm + ring * step_mm;
      boxes.push_back(box_around(
          {at.x_mm + side.x_mm * (gap + width_mm / 2), at.y_mm + side.y_mm * (gap + height_mm / 2)}, width_mm,
          height_mm));
    }
  return boxes;
}

}  // namespace selion
