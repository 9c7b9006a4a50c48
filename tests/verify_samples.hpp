// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "selion/field/block.hpp"
#include "selion/verify/verify.hpp"

namespace selion {

/// A line a finding; empty where a plan keeps every rule.
std::string text_of(const Verdict& verdict);

/// A plan as whoever drives it reads it.
PlanFile written(const Field& field, const std::string& job);
PlanFile written(const Field& field, const std::string& job, Repair repair);

std::filesystem::path sample_file(const std::string& name);
Field sample(const std::string& name);

/// GeoJSON of a feature around 10 E 50 N: polygons, one line or one point, in metres.
std::string feature_of(const std::vector<Polygon>& parts, const std::string& properties);
std::string feature_of(const std::vector<Point>& line, const std::string& properties);
std::string feature_of(Point at, const std::string& properties);
std::string collection_of(const std::vector<std::string>& features);

}  // namespace selion
