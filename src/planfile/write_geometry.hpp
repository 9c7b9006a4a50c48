// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rules.hpp"
#include "selion/core/json_writer.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

// Decimals of plan.geojson (docs/plan.md, "Numbers"). A heading or curvature of a curve acts over the whole
// length of its piece, and joints agree to 1e-6 m at the end of a swath of some kilometres: hence its twelve.
inline constexpr int kCoordinateDecimals = 9;
inline constexpr int kMetreDecimals = 4;
inline constexpr int kSecondDecimals = 4;
inline constexpr int kSpeedDecimals = 4;
inline constexpr int kRadianDecimals = 8;
inline constexpr int kCurvatureDecimals = 8;
inline constexpr int kDegreeDecimals = 6;
inline constexpr int kCurveMetreDecimals = 9;
inline constexpr int kCurveAngleDecimals = 12;

/// @throws std::logic_error saying `what` and the problem, where there is one.
void check(const std::string& what, const Problem& problem);
/// `value`. @throws std::logic_error where it is below `low`.
int at_least(int low, int value, const char* key);

/// Begins a feature on one line: its properties follow, and an end_feature with its geometry.
void begin_feature(JsonWriter& json, const char* kind);
void begin_feature(JsonWriter& json, const char* kind, int block);
void end_feature(JsonWriter& json, LonLat point);
void end_feature(JsonWriter& json, const LonLatLine& line);
/// A Polygon, or a MultiPolygon where there are several parts.
void end_feature(JsonWriter& json, const std::vector<LonLatArea>& parts);

void write_position(JsonWriter& json, LonLat position);

}  // namespace selion
