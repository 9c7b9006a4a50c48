// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proj_handles.hpp"
#include "raw.hpp"
#include "selion/core/point.hpp"

namespace selion {

/// One way from a file's CRS to WGS84, the best that PROJ can do in a neighbourhood.
struct DatumStep {
  ProjObject operation;  ///< absent: the coordinates are WGS84 longitude and latitude already
  std::string name;
  std::optional<double> accuracy_m;        ///< as PROJ states it
  std::vector<std::string> missing_grids;  ///< of a better way, not installed
};

/// A file's CRS and its ways to WGS84.
class Georeference {
 public:
  /// @throws InputError where PROJ does not know `crs` or it lies nowhere on earth (local, engineering).
  Georeference(const std::string& crs, const std::string& where);

  [[nodiscard]] const std::string& name() const { return name_; }  ///< "EPSG:28992 (Amersfoort / RD New)"
  [[nodiscard]] const std::string& datum() const { return datum_; }
  /// @throws InputError where `p` lies outside the CRS's range, with what that looks like.
  void check(RawPoint p, const std::string& where) const;
  /// A note where `p` is outside the CRS's area of use. @throws InputError where swapped axes would put it
  /// inside.
  [[nodiscard]] std::optional<std::string> outside_area_of_use(RawPoint p, const std::string& where) const;
  /// The step for a field at `p`; made once for each quarter of a degree.
  const DatumStep& step_at(RawPoint p);
  [[nodiscard]] LonLat converted(RawPoint p, const DatumStep& step) const;

 private:
  struct Area {
    double west = -180, south = -90, east = 180, north = 90;
    std::string name;
  };
  [[nodiscard]] LonLat rough(RawPoint p) const;
  [[nodiscard]] DatumStep best_step(LonLat low, LonLat high) const;
  [[nodiscard]] bool in_area(LonLat p, double margin_deg) const;

  ProjContext context_;
  ProjObject crs_;
  ProjObject rough_;
  std::string name_;
  std::string datum_;
  std::optional<double> degrees_per_unit_;  ///< of geographic CRSs
  bool is_wgs84_ = false;                   ///< longitude and latitude in degrees on WGS84: nothing to do
  std::optional<Area> area_;
  std::map<std::pair<int, int>, DatumStep> steps_;
};

/// Whether two definitions mean the same CRS, axis order aside.
bool same_crs(const std::string& a, const std::string& b);

}  // namespace selion
