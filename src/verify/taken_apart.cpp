// SPDX-License-Identifier: GPL-3.0-or-later
#include "taken_apart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "frame_crs.hpp"
#include "selion/core/error.hpp"

namespace selion::verifying {
namespace {

constexpr double kFar_m = 1e6;  // no field reaches as far from its frame's origin
constexpr double kMostBend_per_m = 1e3;
constexpr double kMostTurned_rad = 20;  // in one piece: three rounds

/// Keys that belong to another kind of piece would lead the check astray.
bool of_its_kind(const PieceRecord& p) {
  const bool pivots = p.kind == "pivot";
  const bool waits = p.kind == "wait";
  return p.angle_rad.has_value() == pivots && p.duration_s.has_value() == (pivots || waits) &&
         (waits ? p.ref.empty() : !p.for_robot) && p.duration_s.value_or(0) >= 0;
}

bool plausible(const PieceRecord& p) {
  const double end = p.curvature_per_m + p.sharpness_per_m2 * p.length_m;
  return std::abs(p.x_m) < kFar_m && std::abs(p.y_m) < kFar_m && p.length_m >= 0 && p.length_m < kFar_m &&
         std::abs(p.curvature_per_m) < kMostBend_per_m && std::abs(end) < kMostBend_per_m &&
         (std::abs(p.curvature_per_m) + std::abs(end)) / 2 * p.length_m < kMostTurned_rad &&
         std::abs(p.angle_rad.value_or(0)) < kMostTurned_rad && 1 - p.offset_m * p.curvature_per_m > 0 &&
         1 - p.offset_m * end > 0;
}

/// What the frame makes of a metre of ground at the origin, eastwards and northwards.
struct Unit {
  Point east;
  Point north;
};

Unit unit_at(const Plane& plane, LonLat origin) {
  constexpr double kStep_deg = 1e-3;
  const Point step = ground_m({-kStep_deg / 2, origin.lat_deg - kStep_deg / 2},
                              {kStep_deg / 2, origin.lat_deg + kStep_deg / 2});
  const auto at = [&](double lon, double lat_deg) {
    return plane.to_local({origin.lon_deg + lon * kStep_deg, origin.lat_deg + lat_deg * kStep_deg});
  };
  return {(1 / step.x_m) * (at(0.5, 0) - at(-0.5, 0)), (1 / step.y_m) * (at(0, 0.5) - at(0, -0.5))};
}

std::string trajectory_name(const TrajectoryRecord& t) {
  return "the trajectory of robot " + std::to_string(t.robot) + " in block " + std::to_string(t.block);
}

}  // namespace

TakenApart::TakenApart(const PlanFile& file)
    : plane_{file.proj}, findings_{plane_}, case_{file, plane_, vehicle_, {}, {}, findings_} {
  std::string trouble;
  vehicle_ = vehicle_of(file.job_json, trouble);
  check_job(trouble);
  check_frame();
  check_trajectories();
  usable_ = usable_ && check_tangles(case_);
  if (!usable_) return;
  check_grounds(case_);
  usable_ = check_reach(case_);
  if (!usable_) return;
  for (const TrajectoryRecord& record : file.trajectories) case_.drives.push_back(driven_of(record));
}

void TakenApart::refuse(const char* code, const std::string& what) {
  findings_.add(code, 0, std::nullopt, {}, what);
  usable_ = false;
}

void TakenApart::check_job(const std::string& trouble) {
  if (!trouble.empty())
    return refuse("job", "the job lacks, or has no value that this version plans with for: " + trouble);
  try {
    validate(vehicle_.machine);
  } catch (const InputError& error) {
    refuse("job", error.what());
  }
}

/// The frame keeps lengths, is true to its origin, and lies where the field is.
void TakenApart::check_frame() {
  constexpr double kStretch = 1e-3;
  constexpr double kOrigin_m = 0.01;
  if (!plane_.valid()) return refuse("frame", "PROJ makes nothing of the frame " + case_.plan.proj);
  const LonLat origin = case_.plan.origin;
  const Unit unit = unit_at(plane_, origin);
  for (const Point side : {unit.east, unit.north})
    if (const double stretch = length_m(side) - 1; !(std::abs(stretch) <= kStretch))
      return refuse("frame", "the frame stretches lengths by " + shown(100 * stretch, 3) + " %");
  if (!(std::abs(cross(unit.east, unit.north) - 1) <= 3 * kStretch))
    return refuse("frame", "east and north stand askew in the frame, or the wrong way round");
  const double off = length_m(plane_.to_local(origin));
  if (!(off <= kOrigin_m))
    return refuse("frame", "the frame's origin lies " + shown(off, 1) + " m from where the file says");
  if (const std::string& crs = vehicle_.frame_crs; usable_ && !is_frame_of(plane_, origin, crs))
    refuse("frame", "the frame is not the one that the job names, " + crs);
}

void TakenApart::check_trajectories() {
  const PlanFile& file = case_.plan;
  if (file.trajectories.empty())
    findings_.add("no_trajectory", 0, std::nullopt, {}, "the file has no trajectory");
  std::set<std::pair<int, int>> seen;
  for (const TrajectoryRecord& t : file.trajectories) {
    if (!seen.emplace(t.block, t.robot).second)
      return refuse("block", trajectory_name(t) + " is there twice");
    check_trajectory(t);
  }
  check_copies();
}

/// Another robot that drives the very same way.
void TakenApart::check_copies() {
  const auto& all = case_.plan.trajectories;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (all[i].block == all[k].block && all[i].pieces == all[k].pieces)
        return refuse("block", trajectory_name(all[i]) + " is that of robot " + std::to_string(all[k].robot));
}

void TakenApart::check_trajectory(const TrajectoryRecord& t) {
  const std::string name = trajectory_name(t);
  const PlanFile& file = case_.plan;
  const std::size_t blocks = file.fields.empty() ? 0 : file.fields.front().parts.size();
  if (t.block < 1 || static_cast<std::size_t>(t.block) > blocks)
    refuse("block", name + " belongs to no block of the field");
  if (t.pieces.empty() || t.line.size() < 2) refuse("no_trajectory", name + " is empty");
  const auto refuse_unless = [&](bool (*sound)(const PieceRecord&), const std::string& what) {
    const auto odd = std::ranges::find_if_not(t.pieces, sound);
    if (odd != t.pieces.end())
      refuse("piece",
             name + ": piece " + std::to_string(odd - t.pieces.begin() + 1) + " (" + odd->kind + ")" + what);
  };
  refuse_unless(plausible, " has a length below 0, or numbers that no machine drives");
  refuse_unless(of_its_kind, " has keys of another kind of piece, or a duration below 0");
  const double wide = vehicle_.machine.working_width_m;
  if (!(std::abs(t.working_width_m - wide) <= 1e-3))
    findings_.add("line_width", t.block, std::nullopt, {t.working_width_m, wide},
                  name + " is said to work " + shown(t.working_width_m, 3) + " m, the tool is " +
                      shown(wide, 3) + " m wide");
}

std::string piece_name(const Driven& driven, std::size_t piece) {
  const PieceRecord& record = driven.pieces[piece].record();
  return "robot " + std::to_string(driven.record->robot) + ", piece " + std::to_string(piece + 1) + " (" +
         record.kind + (record.ref.empty() ? "" : " " + record.ref) + ")";
}

}  // namespace selion::verifying
