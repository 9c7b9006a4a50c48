// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geos.hpp"
#include "segments.hpp"

namespace selion::verifying {

/// Lines that many rectangles are compared with. GEOS decides, but for rectangles that lie well off.
class Border {
 public:
  explicit Border(const Shape& lines) : prepared_{lines}, segments_{lines_of(lines)} {}

  [[nodiscard]] bool touches(const Corners& rectangle) const {
    return !segments_.clear_of(rectangle) && prepared_.touches(rectangle);
  }

 private:
  Prepared prepared_;
  Segments segments_;
};

}  // namespace selion::verifying
