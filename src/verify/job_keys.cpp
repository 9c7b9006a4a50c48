// SPDX-License-Identifier: GPL-3.0-or-later
#include "job_keys.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

namespace selion::verifying {
namespace {

using Names = std::span<const std::string_view>;

constexpr auto kMachine = std::to_array<std::string_view>(
    {"preset",         "kind",           "working_width_m",   "tool_x_m",       "body_width_m",
     "front_m",        "rear_m",         "wheelbase_m",       "track_m",        "max_steer_deg",
     "max_speed_mps",  "work_speed_mps", "turn_speed_mps",    "max_accel_mps2", "max_steer_rate_deg_s",
     "max_brake_mps2", "mass_kg",        "max_lateral_mps2",  "may_reverse",    "min_turn_radius_m",
     "safety_gap_m",   "tyre_width_m",   "safety_radius_m",   "clearance_m",    "run_in_m",
     "tool_raise_s",   "tool_lower_s",   "min_work_radius_m", "may_pivot",      "guidance_sd_m"});
constexpr auto kField = std::to_array<std::string_view>(
    {"edge_margin_m", "obstacle_clearance_m", "water_margin_m", "overhang_m", "boundary_accuracy_m"});
constexpr auto kFrame = std::to_array<std::string_view>({"crs"});
constexpr auto kLayout = std::to_array<std::string_view>(
    {"kind", "direction", "ab", "ab_shift_m", "overlap_m", "row_spacing_m", "tramlines"});
constexpr auto kHeadland = std::to_array<std::string_view>({"passes", "order", "corners"});
constexpr auto kRoute = std::to_array<std::string_view>({"order", "start"});
constexpr auto kOutput = std::to_array<std::string_view>({"units", "paper"});

/// None where no table is called so.
Names keys_of(const std::string& table) {
  if (table == "machine") return kMachine;
  if (table == "field") return kField;
  if (table == "frame") return kFrame;
  if (table == "layout") return kLayout;
  if (table == "headland") return kHeadland;
  if (table == "route") return kRoute;
  if (table == "output") return kOutput;
  return {};
}

}  // namespace

std::vector<std::string> unknown_keys(const std::string& job_json) {
  const auto job = nlohmann::json::parse(job_json, nullptr, false);
  std::vector<std::string> unknown;
  for (const auto& [table, keys] : job.items()) {
    if (table == "operation") continue;
    const Names known = keys_of(table);
    if (known.empty() || !keys.is_object()) {
      unknown.push_back(table);
      continue;
    }
    for (const auto& [key, value] : keys.items())
      if (std::ranges::find(known, key) == known.end()) unknown.emplace_back(table).append(".").append(key);
  }
  return unknown;
}

}  // namespace selion::verifying
