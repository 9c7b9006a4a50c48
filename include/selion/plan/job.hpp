// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "selion/core/machine.hpp"
#include "selion/layout/layout.hpp"
#include "selion/route/route.hpp"

namespace selion {

enum class Operation { tillage, seeding, weeding, spraying, mowing, harvest, scouting };

/// Everything that steers a plan: one TOML file, or flags. Every default stands here, once.
struct Job {
  Operation operation = Operation::seeding;
  Machine machine;
  bool machine_assumed = true;  ///< nobody named a machine

  struct FieldKeys {  // [field]: the distances kept
    double edge_margin_m = 0.3;
    double obstacle_clearance_m = 0.5;
    double water_margin_m = 3;
    double overhang_m = 0;
    std::optional<double> boundary_accuracy_m;  ///< absent: unknown
    friend bool operator==(const FieldKeys&, const FieldKeys&) = default;
  } field;

  struct FrameKeys {  // [frame]
    std::string crs = "auto";
    friend bool operator==(const FrameKeys&, const FrameKeys&) = default;
  } frame;

  struct LayoutKeys {  // [layout]
    std::string kind = "linear";
    std::string direction = "edge";           ///< edge | p3 | a compass heading in degrees
    std::optional<std::array<double, 4>> ab;  ///< lon, lat of A, lon, lat of B
    double ab_shift_m = 0;                    ///< right of A -> B positive
    double overlap_m = 0;
    double row_spacing_m = 0.75;
    int tramlines = 0;
    friend bool operator==(const LayoutKeys&, const LayoutKeys&) = default;
  } layout;

  struct HeadlandKeys {         // [headland]
    std::optional<int> passes;  ///< absent: "auto"
    HeadlandOrder order = HeadlandOrder::last;
    HeadlandCorners corners = HeadlandCorners::round;
    friend bool operator==(const HeadlandKeys&, const HeadlandKeys&) = default;
  } headland;

  struct RouteKeys {  // [route]
    std::string order = "adjacent";
    std::string start;  ///< "gate:1"; empty: the planner chooses
    friend bool operator==(const RouteKeys&, const RouteKeys&) = default;
  } route;

  struct OutputKeys {  // [output]
    std::string units = "metric";
    std::string paper = "A4";
    friend bool operator==(const OutputKeys&, const OutputKeys&) = default;
  } output;

  friend bool operator==(const Job&, const Job&) = default;
};

/// As written in a job file: "seeding", "first".
std::string_view name_of(Operation operation);
std::string_view name_of(HeadlandOrder order);

/// When the headland is worked unless the job says so itself: last for tillage, seeding and weeding, first
/// for spraying, mowing and harvest, none for scouting.
HeadlandOrder usual_headland_order(Operation operation);

/// @throws InputError starting with the key ("layout.overlap_m = 9 ...") for a value out of its range, and
/// for what a later version will do ("not supported yet"), naming what this one does.
void validate(const Job& job);

}  // namespace selion
