// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "drawing.hpp"

namespace selion {

/// Gives out room on the page: nothing that it has placed overlaps anything else that it holds.
class LabelPlacer {
 public:
  /// Labels stay inside `room`.
  explicit LabelPlacer(PageBox room) : room_{room} {}

  [[nodiscard]] bool is_free(const PageBox& box) const;
  /// Takes `box` whether it is free or not: a symbol that must stand where it is.
  void take(const PageBox& box) { taken_.push_back(box); }
  /// Takes the first of `candidates` that is free; none where no one is.
  std::optional<PageBox> place(const std::vector<PageBox>& candidates);

  [[nodiscard]] const std::vector<PageBox>& taken() const { return taken_; }

 private:
  PageBox room_;
  std::vector<PageBox> taken_;
};

/// Boxes of this size around `at`, nearest first, in rings up to `reach_mm` from it.
std::vector<PageBox> boxes_near(PagePoint at, double width_mm, double height_mm, double gap_mm,
                                double reach_mm);

}  // namespace selion
