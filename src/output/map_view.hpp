// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "drawing.hpp"
#include "selion/core/point.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

/// The plane of a plan, from its PROJ string.
class PlanPlane {
 public:
  /// @throws InputError where PROJ cannot use `proj`.
  explicit PlanPlane(const std::string& proj);
  ~PlanPlane();
  PlanPlane(const PlanPlane&) = delete;
  PlanPlane& operator=(const PlanPlane&) = delete;
  PlanPlane(PlanPlane&&) = delete;
  PlanPlane& operator=(PlanPlane&&) = delete;

  [[nodiscard]] Point to_local(LonLat p) const;
  [[nodiscard]] LonLat to_lonlat(Point p) const;
  /// Bearing of the plane's north at `p`, clockwise from true north.
  [[nodiscard]] double convergence_deg(Point p) const;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

/// Where the plane lies on the page: north of the plane is up.
struct MapView {
  const PlanPlane& plane;
  PageBox frame;
  Point centre;  ///< at the frame's middle
  double mm_per_m = 1;

  [[nodiscard]] PagePoint at(Point p) const;
  [[nodiscard]] PagePoint at(LonLat p) const { return at(plane.to_local(p)); }
  [[nodiscard]] PageLine at(const LonLatLine& line) const;
  [[nodiscard]] std::vector<PageLine> at(const LonLatArea& area) const;
  [[nodiscard]] Point local(PagePoint p) const;
  [[nodiscard]] LonLat lonlat(PagePoint p) const { return plane.to_lonlat(local(p)); }
};

double distance_mm(PagePoint a, PagePoint b);
double length_mm(const PageLine& line);

struct PlaceOnLine {
  PagePoint at;
  double heading_rad = 0;  ///< along the line, anticlockwise from the page's right
};
/// @pre the line has two points.
PlaceOnLine place_on(const PageLine& line, double from_start_mm);

/// `line` without the points within 0.05 mm of what is left (Douglas and Peucker 1973): paper shows no more.
PageLine thinned(const PageLine& line);

}  // namespace selion
