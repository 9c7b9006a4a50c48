// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "selion/core/point.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion::verifying {

/// Where a robot is: its axle's centre, the direction of travel, the curvature of its own path.
struct Spot {
  Point at;
  double heading_rad = 0;
  double curvature_per_m = 0;
};

/// A piece of a trajectory, integrated numerically (Gauss-Legendre, as docs/plan.md tells): by way along its
/// curve, from 0 to its length.
class PieceLine {
 public:
  explicit PieceLine(const PieceRecord& record);

  [[nodiscard]] const PieceRecord& record() const { return *record_; }
  [[nodiscard]] double length_m() const { return record_->length_m; }
  [[nodiscard]] bool straight() const {
    return record_->curvature_per_m == 0 && record_->sharpness_per_m2 == 0;
  }
  [[nodiscard]] bool stands() const { return record_->kind == "wait" || record_->kind == "pivot"; }
  [[nodiscard]] Spot spot(double s_m) const;
  [[nodiscard]] double curvature_per_m(double s_m) const;
  /// Where the vehicle points, and its axle's centre.
  [[nodiscard]] Pose vehicle(double s_m) const;
  [[nodiscard]] double vehicle_heading_rad(double s_m) const;
  /// The largest curvature of the robot's path, without its sign.
  [[nodiscard]] double most_curvature_per_m() const;
  /// Way of the robot itself, which an offset from the curve makes longer or shorter, and its inverse.
  [[nodiscard]] double driven_m(double s_m) const;
  [[nodiscard]] double curve_m(double driven_m) const;

 private:
  [[nodiscard]] double angle(double s_m) const;
  [[nodiscard]] Point from(Point at, double from_m, double to_m) const;

  const PieceRecord* record_;
  Point ahead_;  ///< where it begins
  double step_m_ = 0;
  std::vector<Point> knots_;  ///< every step_m_
};

/// A sample of the trajectory and how far the robot has driven there.
struct Moment {
  double t_s = 0;
  double speed_mps = 0;  ///< without its sign
  double way_m = 0;
  double heading_rad = 0;  ///< of the vehicle
  double spin_rad_s = 0;   ///< on the spot; between moments it changes evenly
};

/// A place on a piece.
struct Stop {
  std::size_t piece = 0;
  double s_m = 0;  ///< along its curve
};

/// One trajectory. The moments are empty until the samples have been found on the pieces.
struct Driven {
  const TrajectoryRecord* record = nullptr;
  std::vector<PieceLine> pieces;
  std::vector<double> begin_m;  ///< way driven where each piece begins, and at the end
  std::vector<Moment> moments;

  [[nodiscard]] double whole_m() const { return begin_m.back(); }
  /// Of the pieces that meet there, the last one with a length.
  [[nodiscard]] Stop stop(double way_m) const;
  [[nodiscard]] Spot spot(double way_m) const;
};

Driven driven_of(const TrajectoryRecord& record);

/// When the robot has come that far, and how far it has come by then; by constant acceleration between
/// moments. @pre there are moments.
double time_s(const Driven& driven, double way_m);
/// When it goes on from there, where it may rest.
double departure_s(const Driven& driven, double way_m);
double way_m(const Driven& driven, double t_s);

}  // namespace selion::verifying
