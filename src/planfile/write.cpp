// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "json_document.hpp"
#include "raw_json.hpp"
#include "rules.hpp"
#include "selion/core/json_writer.hpp"
#include "selion/planfile/planfile.hpp"
#include "write_geometry.hpp"
#include "write_trajectory.hpp"

namespace selion {
namespace {

JsonWriter& metres(JsonWriter& json, const char* key, double value) {
  return json.key(key).number(value, kMetreDecimals);
}

JsonWriter& texts(JsonWriter& json, const char* key, const std::vector<std::string>& values,
                  JsonSpread spread) {
  json.key(key).begin_array(spread);
  for (const std::string& value : values) json.text(value);
  return json.end();
}

void write(JsonWriter& json, const FieldRecord& field) {
  begin_feature(json, "field");
  json.key("name").text(field.name);
  metres(json, "area_m2", field.area_m2);
  texts(json, "notes", field.notes, JsonSpread::line);
  end_feature(json, field.parts);
}

void write(JsonWriter& json, const ObstacleRecord& obstacle) {
  check("obstacle", problem_of(obstacle));
  begin_feature(json, "obstacle", obstacle.block);
  json.key("name").text(obstacle.name).key("what").text(obstacle.what);
  end_feature(json, std::vector{obstacle.area});
}

void write(JsonWriter& json, const GateRecord& gate) {
  begin_feature(json, "gate", gate.block);
  json.key("name").text(gate.name);
  if (gate.width_m) metres(json, "width_m", *gate.width_m);
  end_feature(json, gate.at);
}

void write(JsonWriter& json, const CellRecord& cell) {
  begin_feature(json, "cell", cell.block);
  json.key("id").text(cell.id).key("bearing_deg").number(cell.bearing_deg, kDegreeDecimals);
  end_feature(json, cell.parts);
}

void write(JsonWriter& json, const AbRecord& ab) {
  begin_feature(json, "ab", ab.block);
  json.key("bearing_deg").number(ab.bearing_deg, kDegreeDecimals);
  end_feature(json, LonLatLine{ab.a, ab.b});
}

void write(JsonWriter& json, const HeadlandRecord& headland) {
  begin_feature(json, "headland", headland.block);
  metres(json, "depth_m", headland.depth_m);
  json.key("passes").whole(at_least(0, headland.passes, "passes"));
  end_feature(json, headland.parts);
}

void write(JsonWriter& json, const HeadlandPassRecord& pass) {
  begin_feature(json, "headland_pass", pass.block);
  json.key("id").text(pass.id).key("ring").whole(at_least(1, pass.ring, "ring"));
  metres(json, "width_m", pass.width_m);
  end_feature(json, pass.line);
}

void write(JsonWriter& json, const SwathRecord& swath) {
  begin_feature(json, "swath", swath.block);
  json.key("id").text(swath.id).key("cell").text(swath.cell);
  json.key("order").whole(at_least(0, swath.order, "order"));
  metres(json, "width_m", swath.width_m);
  metres(json, "length_m", swath.length_m);
  end_feature(json, swath.line);
}

/// A job that broke the file would break it for every reader, so it is looked at where it comes in.
void write_job(JsonWriter& json, const std::string& job) {
  if (!is_json_object(job)) throw std::logic_error{"the job of a plan must be a JSON object"};
  json.key("job").raw(compacted(job));
}

void write_header(JsonWriter& json, const PlanFile& plan) {
  if (plan.format != kPlanFormat)
    throw std::logic_error{"plan format " + std::to_string(plan.format) + " cannot be written"};
  check("summary", problem_of(plan.summary));
  check("origin", problem_of(plan.origin));
  json.key("selion").begin_object(JsonSpread::lines);
  json.key("format").whole(plan.format).key("version").text(plan.version).key("id").text(plan.id);
  json.key("frame").begin_object(JsonSpread::line).key("proj").text(plan.proj);
  json.key("origin");
  write_position(json, plan.origin);
  json.end();
  write_job(json, plan.job_json);
  json.key("summary").begin_object(JsonSpread::lines);
  for (const SummaryFigure& figure : plan.summary) metres(json, figure.key.c_str(), figure.value);
  json.end();
  texts(json, "warnings", plan.warnings, JsonSpread::lines).end();
}

template <class Record>
void write_all(JsonWriter& json, const std::vector<Record>& records) {
  for (const Record& record : records) write(json, record);
}

}  // namespace

std::string to_geojson(const PlanFile& plan) {
  JsonWriter json;
  json.begin_object(JsonSpread::lines).key("type").text("FeatureCollection");
  write_header(json, plan);
  json.key("features").begin_array(JsonSpread::lines);
  write_all(json, plan.fields);
  write_all(json, plan.obstacles);
  write_all(json, plan.gates);
  write_all(json, plan.cells);
  write_all(json, plan.ab_lines);
  write_all(json, plan.headlands);
  write_all(json, plan.headland_passes);
  write_all(json, plan.swaths);
  for (const TrajectoryRecord& trajectory : plan.trajectories) write_trajectory(json, trajectory);
  json.end().end();
  return json.str() + "\n";
}

}  // namespace selion
