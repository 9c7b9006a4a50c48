// SPDX-License-Identifier: GPL-3.0-or-later
#include "vehicle.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include <nlohmann/json.hpp>

#include "job_keys.hpp"

namespace selion::verifying {
namespace {

/// Reads keys of a job; those that are missing or of another kind are named in `trouble`.
class JobReader {
 public:
  JobReader(const nlohmann::json& job, std::string& trouble) : job_{job}, trouble_{trouble} {}

  double number(const char* table, const char* key) {
    const nlohmann::json* value = find(table, key);
    if (value != nullptr && value->is_number()) return value->get<double>();
    say(table, key);
    return 1;
  }
  /// Absent where one of the words stands there.
  std::optional<double> number_or(const char* table, const char* key,
                                  std::initializer_list<const char*> words) {
    const nlohmann::json* value = find(table, key);
    if (value == nullptr || !value->is_string()) return number(table, key);
    one_of(table, key, words);
    return std::nullopt;
  }
  bool flag(const char* table, const char* key) {
    const nlohmann::json* value = find(table, key);
    if (value != nullptr && value->is_boolean()) return value->get<bool>();
    say(table, key);
    return false;
  }
  std::string word(const char* table, const char* key) {
    const nlohmann::json* value = find(table, key);
    if (value != nullptr && value->is_string()) return value->get<std::string>();
    say(table, key);
    return {};
  }
  std::string one_of(const char* table, const char* key, std::initializer_list<const char*> words) {
    std::string given = word(table, key);
    if (std::ranges::find(words, given) == words.end()) say(table, key);
    return given;
  }
  bool is(const char* table, const char* key, const char* wanted) {
    const nlohmann::json* value = find(table, key);
    return value != nullptr && value->is_string() && *value == wanted;
  }
  /// Empty where the list is.
  std::vector<double> numbers(const char* table, const char* key, std::size_t count) {
    const nlohmann::json* value = find(table, key);
    if (value == nullptr || !value->is_array() || (!value->empty() && value->size() != count) ||
        !std::ranges::all_of(*value, [](const nlohmann::json& item) { return item.is_number(); })) {
      say(table, key);
      return {};
    }
    return value->get<std::vector<double>>();
  }
  void say(const std::string& table, const char* key) {
    trouble_ += (trouble_.empty() ? "" : ", ") + table + (table.empty() ? "" : ".") + key;
  }

 private:
  const nlohmann::json* find(const std::string& table, const char* key) {
    if (table.empty()) return job_.contains(key) ? &job_[key] : nullptr;
    const auto at = job_.find(table);
    if (at == job_.end() || !at->is_object()) return nullptr;
    const auto value = at->find(key);
    return value == at->end() ? nullptr : &*value;
  }

  const nlohmann::json& job_;
  std::string& trouble_;
};

void read_measures(Machine& m, JobReader& job) {
  const auto of_machine = [&job](const char* key) { return job.number("machine", key); };
  m.preset = job.word("machine", "preset");
  if (!std::ranges::any_of(machine_presets(), [&](const MachinePreset& p) { return p.name == m.preset; }))
    job.say("machine", "preset");
  m.working_width_m = of_machine("working_width_m");
  m.tool_x_m = of_machine("tool_x_m");
  m.body_width_m = of_machine("body_width_m");
  m.front_m = of_machine("front_m");
  m.rear_m = of_machine("rear_m");
  m.wheelbase_m = of_machine("wheelbase_m");
  m.track_m = of_machine("track_m");
  m.max_steer_deg = of_machine("max_steer_deg");
  m.max_steer_rate_deg_s = of_machine("max_steer_rate_deg_s");
  m.min_turn_radius_m = job.number_or("machine", "min_turn_radius_m", {"auto"});
  m.min_work_radius_m = job.number_or("machine", "min_work_radius_m", {"auto"});
}

void read_powers(Machine& m, JobReader& job) {
  const auto of_machine = [&job](const char* key) { return job.number("machine", key); };
  m.max_speed_mps = of_machine("max_speed_mps");
  m.work_speed_mps = of_machine("work_speed_mps");
  m.turn_speed_mps = of_machine("turn_speed_mps");
  m.max_accel_mps2 = of_machine("max_accel_mps2");
  m.max_brake_mps2 = of_machine("max_brake_mps2");
  m.max_lateral_mps2 = of_machine("max_lateral_mps2");
  m.safety_gap_m = of_machine("safety_gap_m");
  m.run_in_m = of_machine("run_in_m");
  m.tool_raise_s = of_machine("tool_raise_s");
  m.tool_lower_s = of_machine("tool_lower_s");
  m.may_reverse = job.flag("machine", "may_reverse");
  m.may_pivot = job.flag("machine", "may_pivot");
  m.kind = job.one_of("machine", "kind", {"car", "differential"}) == "car" ? MachineKind::car
                                                                           : MachineKind::differential;
}

void read_work(Work& work, JobReader& job) {
  job.one_of("", "operation", {"tillage", "seeding", "weeding", "spraying", "mowing", "harvest", "scouting"});
  job.one_of("headland", "corners", {"round", "fill"});
  job.one_of("layout", "kind", {"linear"});
  for (const auto& [table, key] : {std::pair{"field", "overhang_m"}, {"layout", "tramlines"}})
    if (job.number(table, key) != 0) job.say(table, key);  // this version plans with none
  work.overlap_m = job.number("layout", "overlap_m");
  work.ab_shift_m = job.number("layout", "ab_shift_m");
  work.ab = job.numbers("layout", "ab", 4);
  work.by_p3 = job.is("layout", "direction", "p3");
  work.direction_deg = job.number_or("layout", "direction", {"edge", "p3"});
  work.passes = job.number_or("headland", "passes", {"auto"});
  work.headland_order = job.one_of("headland", "order", {"first", "last", "none"});
  job.one_of("route", "order", {"adjacent"});
  job.one_of("output", "units", {"metric", "imperial"});
  job.one_of("output", "paper", {"A4", "A3", "letter"});
  work.start = job.word("route", "start");
}

}  // namespace

Vehicle vehicle_of(const std::string& job_json, std::string& trouble) {
  const auto job = nlohmann::json::parse(job_json, nullptr, false);
  if (!job.is_object()) {
    trouble = "the whole job";
    return {};
  }
  JobReader reader{job, trouble};
  for (const std::string& key : unknown_keys(job_json)) reader.say("", key.c_str());
  Vehicle vehicle;
  read_measures(vehicle.machine, reader);
  read_powers(vehicle.machine, reader);
  vehicle.edge_margin_m = reader.number("field", "edge_margin_m");
  vehicle.obstacle_clearance_m = reader.number("field", "obstacle_clearance_m");
  vehicle.water_margin_m = reader.number("field", "water_margin_m");
  vehicle.frame_crs = reader.word("frame", "crs");
  read_work(vehicle.work, reader);
  const Machine& m = vehicle.machine;
  constexpr double kDegree = std::numbers::pi / 180;
  vehicle.most_curvature_per_m =
      m.min_turn_radius_m ? 1 / *m.min_turn_radius_m : std::tan(m.max_steer_deg * kDegree) / m.wheelbase_m;
  vehicle.most_working_curvature_per_m = vehicle.most_curvature_per_m;
  if (m.min_work_radius_m)
    vehicle.most_working_curvature_per_m = std::min(vehicle.most_curvature_per_m, 1 / *m.min_work_radius_m);
  vehicle.most_steering_rad_s = m.max_steer_rate_deg_s * kDegree;
  return vehicle;
}

double half_tool_m(const Vehicle& vehicle) {
  return std::max(vehicle.machine.working_width_m, vehicle.machine.body_width_m) / 2;
}

double ring_spacing_m(const Vehicle& vehicle) {
  constexpr double kOverlap_m = 0.02;
  return vehicle.machine.working_width_m - kOverlap_m;
}

double steering_rad_s(const Vehicle& vehicle, double curvature_per_m, double sharpness_per_m2,
                      double speed_mps) {
  const Machine& m = vehicle.machine;
  const double by_way = std::abs(sharpness_per_m2) * speed_mps;
  if (m.kind == MachineKind::differential) return m.track_m * by_way;
  const double tangent = m.wheelbase_m * curvature_per_m;
  return m.wheelbase_m * by_way / (1 + tangent * tangent);
}

}  // namespace selion::verifying
