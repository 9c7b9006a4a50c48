// SPDX-License-Identifier: GPL-3.0-or-later
#include "selion/output/report.hpp"

#include "figures.hpp"
#include "selion/core/json_writer.hpp"

namespace selion {
namespace {

constexpr int kReportFormat = 1;
constexpr int kDecimals = 2;  // of areas, lengths, times and per cents: as far as a person can follow
constexpr int kDegreeDecimals = 4;
constexpr int kCoordinateDecimals = 9;

void figure(JsonWriter& json, const char* key, double value) { json.key(key).number(value, kDecimals); }

void texts(JsonWriter& json, const char* key, const std::vector<std::string>& values) {
  json.key(key).begin_array(JsonSpread::lines);
  for (const std::string& value : values) json.text(value);
  json.end();
}

void position(JsonWriter& json, LonLat at) {
  json.begin_array(JsonSpread::line);
  json.number(at.lon_deg, kCoordinateDecimals).number(at.lat_deg, kCoordinateDecimals).end();
}

void ring(JsonWriter& json, const LonLatLine& corners) {
  json.begin_array(JsonSpread::line);
  for (const LonLat corner : corners) position(json, corner);
  if (!corners.empty()) position(json, corners.front());
  json.end();
}

void place(JsonWriter& json, const Uncovered& uncovered) {
  json.begin_object(JsonSpread::line);
  figure(json, "area_m2", uncovered.area_m2);
  json.key("at");
  position(json, uncovered.at);
  json.key("polygon")
      .begin_object(JsonSpread::line)
      .key("type")
      .text("Polygon")
      .key("coordinates")
      .begin_array(JsonSpread::line);
  ring(json, uncovered.area.shell);
  for (const LonLatLine& hole : uncovered.area.holes) ring(json, hole);
  json.end().end().end();
}

void worked_twice(JsonWriter& json, const BlockReport& block) {
  json.key("worked_twice").begin_object(JsonSpread::lines);
  figure(json, "area_m2", block.twice.total_m2());
  figure(json, "percent", percent(block.twice.total_m2(), block.area_m2));
  figure(json, "last_strip_m2", block.twice.last_strip_m2);
  figure(json, "wedges_m2", block.twice.wedges_m2);
  figure(json, "corners_m2", block.twice.corners_m2);
  figure(json, "pockets_m2", block.twice.pockets_m2);
  json.end();
}

void swath_figures(JsonWriter& json, const BlockReport& block, const std::optional<SwathLengths>& lengths) {
  json.key("swaths")
      .begin_object(JsonSpread::lines)
      .key("strips")
      .whole(block.swaths)
      .key("pieces")
      .whole(block.pieces);
  if (lengths) {
    figure(json, "shortest_m", lengths->shortest->length_m);
    figure(json, "longest_m", lengths->longest->length_m);
  }
  json.end();
}

void drive_figures(JsonWriter& json, const BlockReport& block) {
  json.key("distance").begin_object(JsonSpread::lines);
  figure(json, "total_m", driven_m(block));
  figure(json, "work_m", block.work_m);
  figure(json, "turn_m", block.turn_m);
  figure(json, "transfer_m", block.transfer_m);
  figure(json, "reverse_m", block.reverse_m);
  figure(json, "scrub_m", block.scrub_m);
  json.end().key("time").begin_object(JsonSpread::lines);
  figure(json, "total_s", driven_s(block));
  figure(json, "work_s", block.work_s);
  figure(json, "turn_s", block.turn_s);
  figure(json, "transfer_s", block.transfer_s);
  json.end().key("turns").whole(block.turns).key("transfers").whole(block.transfers);
  json.key("pivots").whole(block.pivots);
}

/// What a block and the total of blocks have in common.
void common_figures(JsonWriter& json, const std::vector<BlockReport>& blocks,
                    const std::optional<SwathLengths>& lengths) {
  const BlockReport block = total(blocks);
  figure(json, "area_m2", block.area_m2);
  figure(json, "covered_m2", block.covered_m2);
  figure(json, "covered_percent", percent(block.covered_m2, block.area_m2));
  figure(json, "uncovered_m2", uncovered_m2(blocks));
  worked_twice(json, block);
  swath_figures(json, block, lengths);
  drive_figures(json, block);
}

void block_figures(JsonWriter& json, const BlockReport& block, const PlanFile& file) {
  const Status status = status_of(block);
  json.begin_object(JsonSpread::lines).key("number").whole(block.number).key("status").text(name_of(status));
  if (status == Status::refused) {
    figure(json, "area_m2", block.area_m2);
    json.key("reason").text(block.refused).end();
    return;
  }
  json.key("bearing_deg").number(block.bearing_deg, kDegreeDecimals);
  json.key("headland").begin_object(JsonSpread::lines).key("passes").whole(block.headland_passes);
  figure(json, "depth_m", block.headland_depth_m);
  figure(json, "turn_depth_m", block.turn_depth_m);
  json.end();
  common_figures(json, {block}, swath_lengths(file, block.number));
  json.key("uncovered").begin_array(JsonSpread::lines);
  for (const Uncovered& uncovered : block.uncovered) place(json, uncovered);
  json.end().end();
}

void verification(JsonWriter& json, const std::optional<Verification>& said) {
  json.key("verification").begin_object(JsonSpread::lines);
  json.key("verdict").text(!said ? "not asked for" : said->faults.empty() ? "passed" : "failed");
  texts(json, "faults", said ? said->faults : std::vector<std::string>{});
  json.end();
}

void counts(JsonWriter& json, const std::vector<BlockReport>& blocks) {
  json.key("blocks").begin_object(JsonSpread::lines);
  for (const Status status : {Status::planned, Status::partial, Status::refused}) {
    long long count = 0;
    for (const BlockReport& block : blocks) count += status_of(block) == status ? 1 : 0;
    json.key(name_of(status)).whole(count);
  }
  json.end();
}

}  // namespace

std::string report_json(const Plan& plan) {
  JsonWriter json;
  json.begin_object(JsonSpread::lines)
      .key("report")
      .whole(kReportFormat)
      .key("version")
      .text(plan.file.version);
  json.key("plan_id").text(plan.file.id);
  json.key("field").text(plan.file.fields.empty() ? std::string{} : plan.file.fields.front().name);
  json.key("status").text(name_of(status_of(plan)));
  verification(json, plan.verification);
  texts(json, "warnings", plan.file.warnings);
  json.key("total").begin_object(JsonSpread::lines);
  counts(json, plan.blocks);
  common_figures(json, plan.blocks, swath_lengths(plan.file, std::nullopt));
  json.end().key("blocks").begin_array(JsonSpread::lines);
  for (const BlockReport& block : plan.blocks) block_figures(json, block, plan.file);
  json.end();
  texts(json, "assumptions", plan.assumptions);
  texts(json, "notes", plan.notes);
  return json.end().str() + "\n";
}

}  // namespace selion
