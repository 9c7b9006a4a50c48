// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "selion/core/point.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {

/// Something that is wrong with a plan. docs/verify.md has the codes.
struct Finding {
  std::string code;  ///< "body_outside", "steering_rate" ...
  std::string what;  ///< a sentence for a person, with its place in the plan
  int block = 0;     ///< 0 where it concerns the whole plan
  std::optional<LonLat> at;
  double measure = 0;  ///< found, in the unit that `what` names
  double limit = 0;    ///< at most, or at least, this was allowed

  friend bool operator==(const Finding&, const Finding&) = default;
};

/// Ground that the tool does not cover, or covers more than once.
struct VerifiedPlace {
  int block = 1;
  LonLatArea area;
  LonLat at;  ///< inside it
  double area_m2 = 0;

  friend bool operator==(const VerifiedPlace&, const VerifiedPlace&) = default;
};

/// What an independent check says of a plan file.
struct Verdict {
  std::vector<Finding> findings;  ///< none: the plan keeps every rule; at most a few of one code and block
  std::vector<VerifiedPlace> missed;  ///< wider than 1 cm on average, largest first, by blocks
  double area_m2 = 0;
  double covered_m2 = 0;
  double twice_m2 = 0;  ///< ground worked three times counts twice

  friend bool operator==(const Verdict&, const Verdict&) = default;
};

/// Which number of a position stands first in a text of coordinates.
enum class TextOrder { lonlat, latlon };

/// The field that a plan was made for, as its owner has it.
struct GivenField {
  std::filesystem::path file;             ///< whatever OGR reads, or coordinates as text
  std::optional<std::string> layer = {};  ///< where the file has several with polygons
  std::optional<std::string> name = {};   ///< of the feature, or its number; else the one at the plan's place
  std::optional<std::string> crs = {};    ///< of files that do not say
  TextOrder order = TextOrder::lonlat;    ///< of text without a header that says
  std::optional<std::filesystem::path> obstacles = {};  ///< a file of further ones
  std::optional<std::filesystem::path> gates = {};      ///< the same
};

/// Checks everything that a plan file says by geometry and integration of its own: frame and field, joints,
/// samples against pieces, limits of the machine, body and tool against border and obstacles between samples
/// too, coverage, that each line is driven once, times, several robots against each other, and every figure
/// of the summary. It shares no curve and no polygon code with the planner.
/// @param given  re-read and compared with the plan's field; absent: the plan's own field is believed.
/// @throws InputError where `given` cannot be read.
Verdict verify(const PlanFile& file, const std::optional<GivenField>& given);

/// Ground that the plan works more than once, wider than 1 cm on average, largest first, by blocks.
std::vector<VerifiedPlace> worked_twice(const PlanFile& plan);

/// A place to look at before the first drive.
struct WatchPlace {
  std::string what;  ///< "border", "obstacle"; of bends "swath 12", "turn" ...
  int block = 1;
  int robot = 1;
  LonLat at;
  double t_s = 0;
  double measure_m = 0;  ///< distance of body or tool, or radius of the curve

  friend bool operator==(const WatchPlace&, const WatchPlace&) = default;
};
struct WatchList {
  std::vector<WatchPlace> closest;   ///< up to ten approaches to border or obstacles, nearest first
  std::vector<WatchPlace> tightest;  ///< up to ten curves, tightest first

  friend bool operator==(const WatchList&, const WatchList&) = default;
};
/// What a person checks in the field before the first drive: approaches 5 m or more from each other.
WatchList watch_list(const PlanFile& plan);

}  // namespace selion
