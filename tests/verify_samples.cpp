// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include "field_samples.hpp"
#include "files.hpp"
#include "selion/core/format.hpp"
#include "selion/plan/job_file.hpp"
#include "selion/plan/plan.hpp"
#include "verify_samples.hpp"

namespace selion {
namespace {

std::string json_of(LonLat p) { return "[" + fixed(p.lon_deg, 9) + "," + fixed(p.lat_deg, 9) + "]"; }

std::string json_of(const std::vector<LonLat>& line) {
  std::string text;
  for (const LonLat p : line) text += (text.empty() ? "[" : ",") + json_of(p);
  return text + "]";
}

std::string ring_json(LonLatRing ring) {
  ring.push_back(ring.front());
  return json_of(ring);
}

std::string feature(const std::string& type, const std::string& coordinates, const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}}";
}

}  // namespace

std::string text_of(const Verdict& verdict) {
  std::string text;
  for (const Finding& finding : verdict.findings) text += finding.code + ": " + finding.what + "\n";
  return text;
}

PlanFile written(const Field& field, const std::string& job) {
  return written(field, job, Repair::notes_only);
}

PlanFile written(const Field& field, const std::string& job, Repair repair) {
  const auto planned = plan(field, job_of(settings_of_toml(job, "test")), repair, no_progress);
  REQUIRE(planned.has_value());
  return plan_from_geojson(to_geojson(planned->file), "test");
}

std::filesystem::path sample_file(const std::string& name) { return data_dir() / "fields" / name; }

Field sample(const std::string& name) { return read_file(sample_file(name)).at(0); }

std::string feature_of(const std::vector<Polygon>& parts, const std::string& properties) {
  std::string all;
  for (const Polygon& part : parts) {
    const LonLatPolygon polygon = polygon_of_metres(part);
    all += (all.empty() ? "[[" : ",[") + ring_json(polygon.shell);
    for (const LonLatRing& hole : polygon.holes) all += "," + ring_json(hole);
    all += "]";
  }
  return feature("MultiPolygon", all + "]", properties);
}

std::string feature_of(const std::vector<Point>& line, const std::string& properties) {
  return feature("LineString", json_of(polygon_of_metres({line, {}}).shell), properties);
}

std::string feature_of(Point at, const std::string& properties) {
  return feature("Point", json_of(polygon_of_metres({{at}, {}}).shell.front()), properties);
}

std::string collection_of(const std::vector<std::string>& features) {
  std::string all;
  for (const std::string& one : features) all += (all.empty() ? "" : ",") + one;
  return R"({"type":"FeatureCollection","features":[)" + all + "]}";
}

}  // namespace selion
