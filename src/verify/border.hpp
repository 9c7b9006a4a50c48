// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geos.hpp"
#include "segments.hpp"

namespace selion::verifying {

/// Lines that many rectangles are compared with.
class Border {
 public:
  explicit Border(const Shape& lines) : prepared_{lines}, segments_{lines_of(lines)} {}

  /// Quick; true only where the rectangle lies off by a micrometre or more.
  [[nodiscard]] bool clear_of(const Corners& rectangle) const { return segments_.clear_of(rectangle); }
  /// As GEOS has it.
  [[nodiscard]] bool touches(const Corners& rectangle) const { return prepared_.touches(rectangle); }

 private:
  Prepared prepared_;
  Segments segments_;
};

}  // namespace selion::verifying
