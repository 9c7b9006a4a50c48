// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "selion/core/point.hpp"

namespace selion {

// The records of plan.geojson, as docs/plan.md describes them: plain, in WGS84, nothing derived. Each member
// has an initialiser, so that those with names may be left out.

using LonLatLine = std::vector<LonLat>;
struct LonLatArea {
  LonLatLine shell{};  ///< not closed (the first corner is not repeated)
  std::vector<LonLatLine> holes{};

  friend bool operator==(const LonLatArea&, const LonLatArea&) = default;
};

struct FieldRecord {
  std::vector<LonLatArea> parts{};
  std::string name{};
  double area_m2 = 0;
  std::vector<std::string> notes{};

  friend bool operator==(const FieldRecord&, const FieldRecord&) = default;
};

struct ObstacleRecord {
  int block = 1;
  LonLatArea area{};
  std::string name{};
  std::string what{};  ///< obstacle | no_go | water

  friend bool operator==(const ObstacleRecord&, const ObstacleRecord&) = default;
};

struct GateRecord {
  int block = 1;
  LonLat at{};
  std::string name{};
  std::optional<double> width_m{};

  friend bool operator==(const GateRecord&, const GateRecord&) = default;
};

struct CellRecord {
  int block = 1;
  std::string id{};
  std::vector<LonLatArea> parts{};
  double bearing_deg = 0;

  friend bool operator==(const CellRecord&, const CellRecord&) = default;
};

/// The AB line that the swaths are parallel to: A first, true compass bearing at A.
struct AbRecord {
  int block = 1;
  LonLat a{};
  LonLat b{};
  double bearing_deg = 0;

  friend bool operator==(const AbRecord&, const AbRecord&) = default;
};

struct HeadlandRecord {
  int block = 1;
  std::vector<LonLatArea> parts{};
  double depth_m = 0;
  int passes = 0;

  friend bool operator==(const HeadlandRecord&, const HeadlandRecord&) = default;
};

struct HeadlandPassRecord {
  int block = 1;
  std::string id{};  ///< "H1", "H2" ...
  int ring = 1;      ///< 1 is outermost
  LonLatLine line{};
  double width_m = 0;

  friend bool operator==(const HeadlandPassRecord&, const HeadlandPassRecord&) = default;
};

struct SwathRecord {
  int block = 1;
  std::string id{};  ///< "12", "12a"; pocket pieces "P3"
  std::string cell{};
  LonLatLine line{};  ///< from the A side to the B side
  double width_m = 0;
  double length_m = 0;
  int order = 0;  ///< place in the driving order, from 1; 0 where it is not driven

  friend bool operator==(const SwathRecord&, const SwathRecord&) = default;
};

struct PieceRecord {
  std::string kind{};  ///< swath | headland_pass | turn | pivot | transfer | lane | tramline | wait
  std::string ref{};   ///< id of the swath or pass it drives; else empty
  double x_m = 0, y_m = 0, heading_rad = 0, curvature_per_m = 0, sharpness_per_m2 = 0, length_m = 0;
  double offset_m = 0;
  int gear = 1;
  int tool = 0;
  std::optional<double> angle_rad{};        ///< pivot
  std::optional<double> duration_s{};       ///< pivot, wait
  std::optional<int> for_robot{};           ///< wait
  std::optional<double> until_station_m{};  ///< wait

  friend bool operator==(const PieceRecord&, const PieceRecord&) = default;
};

struct TrajectoryRecord {
  int block = 1;
  int robot = 1;
  double working_width_m = 0;
  double length_m = 0;
  double duration_s = 0;
  std::vector<PieceRecord> pieces{};
  // one entry a sample
  LonLatLine line{};
  std::vector<double> t_s{};
  std::vector<double> heading_rad{};
  std::vector<double> curvature_per_m{};
  std::vector<double> speed_mps{};
  std::vector<int> tool{};

  friend bool operator==(const TrajectoryRecord&, const TrajectoryRecord&) = default;
};

/// A figure of the summary, in the order in which it is printed: "covered_m2", 50912.3.
struct SummaryFigure {
  std::string key{};
  double value = 0;

  friend bool operator==(const SummaryFigure&, const SummaryFigure&) = default;
};

struct PlanFile {
  int format = 1;
  std::string version{};
  std::string proj{};  ///< PROJ string of the local frame
  LonLat origin{};
  std::string job_json{};  ///< the effective job, machines in full, as compact JSON
  std::vector<SummaryFigure> summary{};
  std::vector<std::string> warnings{};  ///< what a person must know before driving it
  std::string id{};
  std::vector<FieldRecord> fields{};
  std::vector<ObstacleRecord> obstacles{};
  std::vector<GateRecord> gates{};
  std::vector<CellRecord> cells{};
  std::vector<AbRecord> ab_lines{};
  std::vector<HeadlandRecord> headlands{};
  std::vector<HeadlandPassRecord> headland_passes{};
  std::vector<SwathRecord> swaths{};
  std::vector<TrajectoryRecord> trajectories{};

  friend bool operator==(const PlanFile&, const PlanFile&) = default;
};

/// The bytes of plan.geojson: RFC 7946, fixed decimals by std::to_chars, the same on any machine and in any
/// locale. Rings are wound as the RFC wants them. Reading it back and writing it again gives the same bytes.
/// @throws std::logic_error for records that no reader could take: numbers that are not finite, lines of one
/// position, arrays of unequal length, a job that is not a JSON object.
std::string to_geojson(const PlanFile& plan);

/// @throws InputError where `text` is not a plan file: naming the place in it and what is wrong.
PlanFile plan_from_geojson(const std::string& text, const std::string& where);

/// What tells this plan from others: 16 hexadecimal digits of a 64-bit hash (FNV-1a with MurmurHash3's
/// finaliser) of the cleaned input and the effective job. The same on every machine; no protection against
/// forgery.
std::string plan_id(const std::string& cleaned_input, const std::string& job_json);

}  // namespace selion
