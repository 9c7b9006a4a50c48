// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "json_document.hpp"
#include "raw_json.hpp"
#include "read_geometry.hpp"
#include "read_trajectory.hpp"
#include "rules.hpp"
#include "selion/planfile/planfile.hpp"

namespace selion {
namespace {

std::vector<std::string> texts(const JsonNode& node) {
  std::vector<std::string> out;
  for (const JsonNode& item : node.items()) out.push_back(item.text());
  return out;
}

int block(const JsonNode& properties) { return properties.at("block").whole(1); }

void read_field(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  plan.fields.push_back({.parts = read_parts(feature),
                         .name = properties.at("name").text(),
                         .area_m2 = properties.at("area_m2").number(),
                         .notes = texts(properties.at("notes"))});
}

void read_obstacle(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  std::vector<LonLatArea> parts = read_parts(feature);
  if (parts.size() != 1) feature.at("geometry").fail("must be a Polygon, not a MultiPolygon");
  plan.obstacles.push_back({.block = block(properties),
                            .area = std::move(parts.front()),
                            .name = properties.at("name").text(),
                            .what = properties.at("what").text()});
  check(properties, problem_of(plan.obstacles.back()));
}

void read_gate(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  const auto width = properties.find("width_m");
  plan.gates.push_back({.block = block(properties),
                        .at = read_point(feature),
                        .name = properties.at("name").text(),
                        .width_m = width ? std::optional{width->number()} : std::nullopt});
}

void read_cell(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  plan.cells.push_back({.block = block(properties),
                        .id = properties.at("id").text(),
                        .parts = read_parts(feature),
                        .bearing_deg = properties.at("bearing_deg").number()});
}

void read_ab(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  const LonLatLine line = read_line(feature);
  if (line.size() != 2)
    feature.at("geometry")
        .fail("must be a line from A to B, of 2 positions, not " + std::to_string(line.size()));
  plan.ab_lines.push_back({.block = block(properties),
                           .a = line[0],
                           .b = line[1],
                           .bearing_deg = properties.at("bearing_deg").number()});
}

void read_headland(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  plan.headlands.push_back({.block = block(properties),
                            .parts = read_parts(feature),
                            .depth_m = properties.at("depth_m").number(),
                            .passes = properties.at("passes").whole(0)});
}

void read_headland_pass(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  plan.headland_passes.push_back({.block = block(properties),
                                  .id = properties.at("id").text(),
                                  .ring = properties.at("ring").whole(1),
                                  .line = read_line(feature),
                                  .width_m = properties.at("width_m").number()});
}

void read_swath(const JsonNode& feature, PlanFile& plan) {
  const JsonNode properties = feature.at("properties");
  plan.swaths.push_back({.block = block(properties),
                         .id = properties.at("id").text(),
                         .cell = properties.at("cell").text(),
                         .line = read_line(feature),
                         .width_m = properties.at("width_m").number(),
                         .length_m = properties.at("length_m").number(),
                         .order = properties.at("order").whole(0)});
}

void add_trajectory(const JsonNode& feature, PlanFile& plan) {
  plan.trajectories.push_back(read_trajectory(feature));
}

struct FeatureKind {
  std::string_view name;
  void (*read)(const JsonNode& feature, PlanFile& plan);
};

constexpr auto kFeatureKinds = std::to_array<FeatureKind>({
    {"field", read_field},
    {"obstacle", read_obstacle},
    {"gate", read_gate},
    {"cell", read_cell},
    {"ab", read_ab},
    {"headland", read_headland},
    {"headland_pass", read_headland_pass},
    {"swath", read_swath},
    {"trajectory", add_trajectory},
});

/// Kinds that the format has and this version does not plan: to pass them over would lose them.
constexpr auto kLaterKinds = std::to_array<std::string_view>({"row", "lane", "tramline", "target", "refill"});

void read_feature(const JsonNode& feature, const std::string& place, PlanFile& plan) {
  if (feature.at("type").text() != "Feature") feature.at("type").fail("must be \"Feature\"");
  const JsonNode kind = feature.at("properties").at("kind");
  const std::string name = kind.text();
  const auto known = std::ranges::find(kFeatureKinds, name, &FeatureKind::name);
  if (known != kFeatureKinds.end()) return known->read(feature.called(place + " (" + name + ")"), plan);
  const bool later = std::ranges::find(kLaterKinds, name) != kLaterKinds.end();
  kind.fail("is \"" + name + "\", which this version of selion does not " + (later ? "read yet" : "know") +
            "; use the version that wrote the file, " + plan.version);
}

void read_summary(const JsonNode& summary, PlanFile& plan) {
  for (const auto& [key, value] : summary.members())
    plan.summary.push_back({std::string{key}, value.number()});
  check(summary, problem_of(plan.summary));
}

void read_header(const JsonNode& root, std::string_view raw, PlanFile& plan) {
  const auto header = root.find("selion");
  if (!header)
    root.fail(
        "this is GeoJSON but no plan: the member \"selion\" is missing; give a plan.geojson written by "
        "selion plan");
  plan.format = header->at("format").whole(0);
  if (plan.format != kPlanFormat) {
    header->at("format").fail("is " + std::to_string(plan.format) + ", this version of selion reads format " +
                              std::to_string(kPlanFormat) + "; use the version that wrote the file");
  }
  plan.version = header->at("version").text();
  plan.id = header->at("id").text();
  if (plan.id.size() != 16 || plan.id.find_first_not_of("0123456789abcdef") != std::string::npos)
    header->at("id").fail("must be 16 hexadecimal digits");
  plan.proj = header->at("frame").at("proj").text();
  check(header->at("frame").at("proj"), problem_of_frame(plan.proj));
  plan.origin = header->at("frame").at("origin").position();
  check(header->at("frame").at("origin"), problem_of(plan.origin));
  plan.job_json = compacted(raw_member(raw, "job"));
  if (!plan.job_json.starts_with('{')) header->at("job").fail("must be an object");
  read_summary(header->at("summary"), plan);
  plan.warnings = texts(header->at("warnings"));
}

/// A coordinate system of GeoJSON's old draft, which RFC 7946 knows no more: where a reader takes it, the
/// plan lies elsewhere.
void refuse_crs(const JsonNode& node) {
  if (const auto crs = node.find("crs"))
    crs->fail("names a coordinate system; a plan is in WGS84, longitude first, and has no such member");
}

}  // namespace

PlanFile plan_from_geojson(const std::string& text, const std::string& where) {
  const JsonDocument document{text, where};
  const JsonNode root = document.root();
  if (root.at("type").text() != "FeatureCollection") root.at("type").fail("must be \"FeatureCollection\"");
  refuse_crs(root);
  PlanFile plan;
  read_header(root, raw_member(text, "selion"), plan);
  int number = 0;
  for (const JsonNode& feature : root.at("features").items()) {
    const std::string place = where + ": feature " + std::to_string(++number);
    refuse_crs(feature.called(place));
    read_feature(feature.called(place), place, plan);
  }
  return plan;
}

}  // namespace selion
