// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_trajectory.hpp"

#include "rules.hpp"
#include "write_geometry.hpp"

namespace selion {
namespace {

void write_numbers(JsonWriter& json, const char* key, const std::vector<double>& values, int decimals) {
  json.key(key).begin_array(JsonSpread::line);
  for (const double value : values) json.number(value, decimals);
  json.end();
}

void write_curve(JsonWriter& json, const PieceRecord& piece) {
  json.key("curve").begin_array(JsonSpread::line);
  json.number(piece.x_m, kCurveMetreDecimals).number(piece.y_m, kCurveMetreDecimals);
  json.number(piece.heading_rad, kCurveAngleDecimals).number(piece.curvature_per_m, kCurveAngleDecimals);
  json.number(piece.sharpness_per_m2, kCurveAngleDecimals).number(piece.length_m, kCurveMetreDecimals);
  json.end();
}

void write_piece(JsonWriter& json, const PieceRecord& piece) {
  check("a piece of a trajectory", problem_of(piece));
  json.begin_object(JsonSpread::line).key("kind").text(piece.kind).key("ref").text(piece.ref);
  write_curve(json, piece);
  json.key("offset_m").number(piece.offset_m, kCurveMetreDecimals);
  json.key("gear").whole(piece.gear).key("tool").whole(piece.tool);
  if (piece.angle_rad) json.key("angle_rad").number(*piece.angle_rad, kRadianDecimals);
  if (piece.duration_s) json.key("duration_s").number(*piece.duration_s, kSecondDecimals);
  if (piece.for_robot) json.key("for_robot").whole(at_least(1, *piece.for_robot, "for_robot"));
  if (piece.until_station_m) json.key("until_station_m").number(*piece.until_station_m, kMetreDecimals);
  json.end();
}

}  // namespace

void write_trajectory(JsonWriter& json, const TrajectoryRecord& trajectory) {
  check("a trajectory", problem_of(trajectory));
  begin_feature(json, "trajectory", trajectory.block);
  json.key("robot").whole(at_least(1, trajectory.robot, "robot"));
  json.key("working_width_m").number(trajectory.working_width_m, kMetreDecimals);
  json.key("length_m").number(trajectory.length_m, kMetreDecimals);
  json.key("duration_s").number(trajectory.duration_s, kSecondDecimals);
  json.key("pieces").begin_array(JsonSpread::line);
  for (const PieceRecord& piece : trajectory.pieces) write_piece(json, piece);
  json.end();
  write_numbers(json, "t_s", trajectory.t_s, kSecondDecimals);
  write_numbers(json, "heading_rad", trajectory.heading_rad, kRadianDecimals);
  write_numbers(json, "curvature_per_m", trajectory.curvature_per_m, kCurvatureDecimals);
  write_numbers(json, "speed_mps", trajectory.speed_mps, kSpeedDecimals);
  json.key("tool").begin_array(JsonSpread::line);
  for (const int tool : trajectory.tool) json.whole(tool);
  json.end();
  end_feature(json, trajectory.line);
}

}  // namespace selion
