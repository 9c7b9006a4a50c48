// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "verify_mutants.hpp"

namespace selion {
namespace {

double either(Dice& dice, double least, double most) {
  return dice.between(least, most) * (dice.pick(2) == 0 ? 1 : -1);
}

template <class Record>
std::function<bool(PlanFile&, Dice&)> without_one(std::vector<Record> PlanFile::*records) {
  return [=](PlanFile& plan, Dice& dice) {
    auto& all = plan.*records;
    if (all.empty()) return false;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(dice.pick(all.size())));
    return true;
  };
}

/// Another number for a key of the job, `by` times what it was.
std::function<bool(PlanFile&, Dice&)> to_job(const std::string& key, double by) {
  return [=](PlanFile& plan, Dice&) {
    const std::string start = "\"" + key + "\":";
    const std::size_t from = plan.job_json.find(start);
    if (from == std::string::npos) return false;
    const std::size_t value = from + start.size();
    const std::size_t to = plan.job_json.find_first_of(",}", value);
    const std::string told = plan.job_json.substr(value, to - value);
    if (told.find_first_not_of("-0123456789.") != std::string::npos || std::stod(told) == 0) return false;
    plan.job_json.replace(value, to - value, std::to_string(std::stod(told) * by));
    return true;
  };
}

bool steer_less(PlanFile& plan, Dice& dice) {
  const bool by_angle = plan.job_json.find(R"("min_turn_radius_m":"auto")") != std::string::npos;
  return by_angle && to_job("max_steer_deg", 0.7)(plan, dice);
}

bool drop_job_key(PlanFile& plan, Dice&) {
  const std::size_t from = plan.job_json.find("\"wheelbase_m\"");
  if (from == std::string::npos) return false;
  plan.job_json.replace(from, 13, "\"wheelbase_n\"");
  return true;
}

bool forbid_reverse(PlanFile& plan, Dice&) {
  bool reverses = false;
  for (const TrajectoryRecord& t : plan.trajectories)
    for (const PieceRecord& p : t.pieces) reverses = reverses || p.gear < 0;
  const std::string allowed = "\"may_reverse\":true";
  const std::size_t from = plan.job_json.find(allowed);
  if (!reverses || from == std::string::npos) return false;
  plan.job_json.replace(from, allowed.size(), "\"may_reverse\":false");
  return true;
}

bool replace_in_frame(PlanFile& plan, const std::string& what, const std::string& by) {
  const std::size_t from = plan.proj.find(what);
  if (from == std::string::npos) return false;
  plan.proj.replace(from, what.size(), by);
  return true;
}

LonLatArea& some_part(PlanFile& plan, Dice& dice) {
  auto& parts = plan.fields.front().parts;
  return parts[dice.pick(parts.size())];
}

/// A square of `half_m` around some place that is driven.
LonLatLine square_on_path(const PlanFile& plan, Dice& dice, double half_m) {
  const TrajectoryRecord& t = plan.trajectories.front();
  const LonLat p = t.line[dice.pick(t.line.size())];
  const double north = half_m / 111320;
  const double east = north / std::cos(p.lat_deg * 0.017453292519943295);
  return {{p.lon_deg - east, p.lat_deg - north},
          {p.lon_deg + east, p.lat_deg - north},
          {p.lon_deg + east, p.lat_deg + north},
          {p.lon_deg - east, p.lat_deg + north}};
}

bool pond_on_path(PlanFile& plan, Dice& dice) {
  plan.obstacles.push_back(
      {plan.trajectories.front().block, LonLatArea{square_on_path(plan, dice, 0.5), {}}, "pond", "obstacle"});
  return true;
}

bool hole_on_path(PlanFile& plan, Dice& dice) {
  const auto block = static_cast<std::size_t>(plan.trajectories.front().block);
  plan.fields.front().parts.at(block - 1).holes.push_back(square_on_path(plan, dice, 0.5));
  return true;
}

bool shrink_field(PlanFile& plan, Dice& dice) {
  const double by = 1 - dice.between(0.02, 0.2);
  for (LonLatArea& part : plan.fields.front().parts) {
    LonLat middle;
    for (const LonLat p : part.shell) {
      middle.lon_deg += p.lon_deg / static_cast<double>(part.shell.size());
      middle.lat_deg += p.lat_deg / static_cast<double>(part.shell.size());
    }
    for (LonLat& p : part.shell)
      p = {middle.lon_deg + by * (p.lon_deg - middle.lon_deg),
           middle.lat_deg + by * (p.lat_deg - middle.lat_deg)};
  }
  return true;
}

bool cross_border(PlanFile& plan, Dice& dice) {
  LonLatLine& shell = some_part(plan, dice).shell;
  if (shell.size() < 4) return false;
  const std::size_t i = dice.pick(shell.size() - 1);
  std::swap(shell[i], shell[i + 1]);
  return true;
}

bool move_corner(PlanFile& plan, Dice& dice) {
  LonLatLine& shell = some_part(plan, dice).shell;
  shell[dice.pick(shell.size())].lat_deg += either(dice, 2e-5, 1e-3);
  return true;
}

bool swap_order(PlanFile& plan, Dice& dice) {
  if (plan.swaths.size() < 2) return false;
  const std::size_t i = dice.pick(plan.swaths.size() - 1);
  if (plan.swaths[i].block != plan.swaths[i + 1].block) return false;
  std::swap(plan.swaths[i].order, plan.swaths[i + 1].order);
  return true;
}

bool repeat_trajectory(PlanFile& plan, Dice& dice) {
  plan.trajectories.push_back(plan.trajectories[dice.pick(plan.trajectories.size())]);
  return true;
}

void move_line(LonLatLine& line, Dice& dice) {
  const double by = either(dice, 1e-6, 1e-5);  // 0.1 to 1 m
  for (LonLat& p : line) p.lat_deg += by, p.lon_deg += by;
}

const std::vector<Mutation>& of_records() {
  using P = PlanFile;
  static const std::vector<Mutation> all{
      {"edit a figure of the summary",
       {"summary"},
       to_one(&P::summary,
              [](auto& f, Dice& d) {
                f.value = f.value == 0 ? 100
                                       : f.value * (1 + either(d, 0.05, 0.5)) +
                                             (f.key == "swaths" || f.key == "pieces" ? 1 : 0);
              })},
      {"drop a figure of the summary", {"summary"}, without_one(&P::summary)},
      {"drop a swath's record", {"unknown_line"}, without_one(&P::swaths)},
      {"rename a swath", {"not_driven"}, to_one(&P::swaths, [](auto& s, Dice&) { s.id += "x"; })},
      {"move a swath's line",
       {"swath_line"},
       to_one(&P::swaths, [](auto& s, Dice& d) { move_line(s.line, d); })},
      {"shorten a swath's line",
       {"swath_line"},
       to_one(&P::swaths,
              [](auto& s, Dice& d) {
                const double share = d.between(0.1, 0.5);
                s.line.back().lon_deg += share * (s.line.front().lon_deg - s.line.back().lon_deg);
                s.line.back().lat_deg += share * (s.line.front().lat_deg - s.line.back().lat_deg);
              })},
      {"edit a swath's length",
       {"line_length"},
       to_one(&P::swaths, [](auto& s, Dice& d) { s.length_m += either(d, 0.1, 9); })},
      {"edit a swath's width",
       {"line_width"},
       to_one(&P::swaths, [](auto& s, Dice& d) { s.width_m += d.between(0.1, 1); })},
      {"swap the order of two swaths", {"swath_order"}, swap_order},
      {"drop a pass's record", {"unknown_line"}, without_one(&P::headland_passes)},
      {"move a pass's line",
       {"pass_line"},
       to_one(&P::headland_passes, [](auto& p, Dice& d) { move_line(p.line, d); })},
      {"edit the area",
       {"field_area"},
       to_one(&P::fields, [](auto& f, Dice& d) { f.area_m2 *= 1 + either(d, 0.001, 1); })},
      {"shrink the field", {"body_outside", "tool_outside", "path_outside"}, shrink_field},
      {"cross the border", {"field_shape", "field_area"}, cross_border},
      {"move a corner", {"field_area"}, move_corner},
      {"drop the field", {"field", "block"}, without_one(&P::fields)},
      {"an obstacle on the path", {"body_obstacle", "tool_obstacle", "path_outside"}, pond_on_path},
      {"a hole on the path", {"body_outside", "tool_outside", "path_outside"}, hole_on_path},
      {"another place of the frame",
       {"frame"},
       [](P& p, Dice& d) { return replace_in_frame(p, "+lat_0=", "+lat_0=1" + std::to_string(d.pick(9))); }},
      {"a frame that stretches",
       {"frame"},
       [](P& p, Dice&) { return replace_in_frame(p, "+k=1", "+k=1.01"); }},
      {"a mirrored frame",
       {"frame"},
       [](P& p, Dice&) { return replace_in_frame(p, "+k=1", "+axis=wnu +k=1"); }},
      {"a frame that stretches eastwards",
       {"frame"},
       [](P& p, Dice&) {
         p.proj = "+proj=pipeline +step " + p.proj + " +step +proj=affine +s11=0.7";
         return true;
       }},
      {"a frame of nothing",
       {"frame"},
       [](P& p, Dice&) { return replace_in_frame(p, "+proj=tmerc", "+proj=nothing"); }},
      {"another origin",
       {"frame"},
       [](P& p, Dice& d) {
         p.origin.lat_deg += either(d, 1e-3, 10);
         return true;
       }},
      {"swap the origin's coordinates",
       {"frame"},
       [](P& p, Dice&) {
         std::swap(p.origin.lat_deg, p.origin.lon_deg);
         return true;
       }},
      {"edit the duration",
       {"duration"},
       to_one(&P::trajectories, [](auto& t, Dice& d) { t.duration_s += either(d, 0.1, 9); })},
      {"edit the length",
       {"length"},
       to_one(&P::trajectories, [](auto& t, Dice& d) { t.length_m += either(d, 0.1, 9); })},
      {"edit the trajectory's width",
       {"line_width"},
       to_one(&P::trajectories, [](auto& t, Dice&) { t.working_width_m += 1; })},
      {"another block", {"block"}, to_one(&P::trajectories, [](auto& t, Dice&) { t.block += 7; })},
      {"drop a trajectory", {"not_driven", "no_trajectory"}, without_one(&P::trajectories)},
      {"repeat a trajectory", {"block"}, repeat_trajectory},
      {"a machine that steers less", {"curvature"}, steer_less},
      {"a machine that steers more slowly", {"steering_rate"}, to_job("max_steer_rate_deg_s", 0.5)},
      {"a slower machine", {"speed", "job"}, to_job("work_speed_mps", 0.8)},
      {"a machine slower in turns", {"speed"}, to_job("turn_speed_mps", 0.8)},
      {"a weaker machine", {"acceleration"}, to_job("max_accel_mps2", 0.5)},
      {"weaker brakes", {"acceleration"}, to_job("max_brake_mps2", 0.5)},
      {"a machine that tips sooner", {"lateral"}, to_job("max_lateral_mps2", 0.3)},
      {"a wider tool", {"line_width"}, to_job("working_width_m", 1.1)},
      {"a wider body", {"body_outside", "body_obstacle"}, to_job("body_width_m", 3)},
      {"a longer body", {"body_outside", "body_obstacle"}, to_job("front_m", 3)},
      {"a tool elsewhere", {"swath_line"}, to_job("tool_x_m", 2)},
      {"a machine that may not reverse", {"reverse"}, forbid_reverse},
      {"a key that is missing", {"job"}, drop_job_key},
  };
  return all;
}

}  // namespace

std::span<const Mutation> mutations_of_records() { return of_records(); }

}  // namespace selion
