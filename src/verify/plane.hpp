// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "selion/core/point.hpp"

struct PJconsts;
struct pj_ctx;

namespace selion::verifying {

/// The local metres of a plan file: between them and WGS84 by its PROJ string.
class Plane {
 public:
  explicit Plane(const std::string& proj);
  /// Of a code, "EPSG:2154".
  static Plane of_code(const std::string& code);

  /// False where PROJ cannot make anything of the string.
  [[nodiscard]] bool valid() const { return transform_ != nullptr; }
  /// NaN beyond the projection's reach.
  [[nodiscard]] Point to_local(LonLat p) const;
  [[nodiscard]] LonLat to_lonlat(Point p) const;
  [[nodiscard]] std::vector<Point> to_local(const std::vector<LonLat>& line) const;

 private:
  Plane();

  std::shared_ptr<pj_ctx> context_;
  std::shared_ptr<PJconsts> transform_;
  bool in_radians_ = false;
};

/// Metres east and north, on WGS84, of a place close by.
Point ground_m(LonLat from, LonLat to);

}  // namespace selion::verifying
