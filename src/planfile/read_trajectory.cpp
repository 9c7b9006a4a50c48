// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_trajectory.hpp"

#include <string>

#include "read_geometry.hpp"
#include "rules.hpp"

namespace selion {
namespace {

constexpr std::size_t kCurveNumbers = 6;

void read_curve(const JsonNode& node, PieceRecord& piece) {
  const std::vector<double> curve = node.numbers();
  if (curve.size() != kCurveNumbers) {
    node.fail("has " + std::to_string(curve.size()) +
              " numbers, it needs 6: x, y, heading_rad, curvature_per_m, sharpness_per_m2, length_m");
  }
  piece.x_m = curve[0];
  piece.y_m = curve[1];
  piece.heading_rad = curve[2];
  piece.curvature_per_m = curve[3];
  piece.sharpness_per_m2 = curve[4];
  piece.length_m = curve[5];
}

std::optional<double> optional_number(const JsonNode& node, const char* key) {
  const auto member = node.find(key);
  return member ? std::optional{member->number()} : std::nullopt;
}

PieceRecord read_piece(const JsonNode& node) {
  PieceRecord piece;
  piece.kind = node.at("kind").text();
  piece.ref = node.at("ref").text();
  read_curve(node.at("curve"), piece);
  piece.offset_m = node.at("offset_m").number();
  piece.gear = node.at("gear").whole(-1);
  piece.tool = node.at("tool").whole(0);
  piece.angle_rad = optional_number(node, "angle_rad");
  piece.duration_s = optional_number(node, "duration_s");
  if (const auto robot = node.find("for_robot")) piece.for_robot = robot->whole(1);
  piece.until_station_m = optional_number(node, "until_station_m");
  check(node, problem_of(piece));
  return piece;
}

}  // namespace

TrajectoryRecord read_trajectory(const JsonNode& feature) {
  const JsonNode properties = feature.at("properties");
  TrajectoryRecord trajectory;
  trajectory.block = properties.at("block").whole(1);
  trajectory.robot = properties.at("robot").whole(1);
  trajectory.working_width_m = properties.at("working_width_m").number();
  trajectory.length_m = properties.at("length_m").number();
  trajectory.duration_s = properties.at("duration_s").number();
  for (const JsonNode& piece : properties.at("pieces").items())
    trajectory.pieces.push_back(read_piece(piece));
  trajectory.t_s = properties.at("t_s").numbers();
  trajectory.heading_rad = properties.at("heading_rad").numbers();
  trajectory.curvature_per_m = properties.at("curvature_per_m").numbers();
  trajectory.speed_mps = properties.at("speed_mps").numbers();
  trajectory.tool = properties.at("tool").wholes(0);
  trajectory.line = read_line(feature);
  check(properties, problem_of(trajectory));
  return trajectory;
}

}  // namespace selion
