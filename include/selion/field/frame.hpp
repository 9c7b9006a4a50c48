// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "selion/core/point.hpp"
#include "selion/field/field.hpp"

namespace selion {

/// Between WGS84 and metres in a plane. Copies share one PROJ object: use a copy per thread only after
/// `cloned`.
class LocalFrame {
 public:
  /// Transverse Mercator centred on `origin`, scale 1 there: lengths within 1e-8 over 1 km, 3e-7 over 5 km.
  static LocalFrame centred(LonLat origin);
  /// Any projected CRS in metres by its code, "EPSG:2154", moved so that `origin` is (0, 0).
  /// @throws InputError where PROJ does not know it, or it is not projected in metres.
  static LocalFrame of_crs(const std::string& code, LonLat origin);

  [[nodiscard]] Point to_local(LonLat p) const;
  [[nodiscard]] LonLat to_lonlat(Point p) const;
  [[nodiscard]] const std::string& proj() const {
    return proj_;
  }  ///< PROJ string of the plane, false origin included
  [[nodiscard]] LonLat origin() const { return origin_; }
  /// True bearing at p of the unit vector `ahead` of the frame, clockwise from north, -180 to 180 degrees.
  /// Not its own bearing and the convergence where the frame keeps no angles.
  [[nodiscard]] double bearing_deg(Point p, Point ahead) const;
  /// Grid convergence at p: bearing of the frame's north (y) clockwise from true north, degrees.
  [[nodiscard]] double convergence_deg(Point p) const;
  [[nodiscard]] LocalFrame cloned() const;

 private:
  struct Projection;
  LocalFrame(std::string proj, LonLat origin);
  std::shared_ptr<const Projection> projection_;
  std::string proj_;
  LonLat origin_;
  bool same_datum_ = false;  ///< as WGS84: the way back needs no second look
};

/// Centre of all parts of the field, the antimeridian unwrapped.
LonLat centre(const Field& field);

}  // namespace selion
