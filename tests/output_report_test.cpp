// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "files.hpp"
#include "output_plan_samples.hpp"
#include "selion/output/report.hpp"

using namespace selion;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> out;
  for (const auto& [key, value] : object.items()) out.push_back(key);
  return out;
}

void add_keys(const Json& value, std::set<std::string>& out) {
  if (value.is_object() && value.contains("coordinates")) return;  // GeoJSON describes these
  if (value.is_object()) {
    for (const std::string& key : keys(value)) out.insert(key);
  }
  if (value.is_structured()) {
    for (const Json& part : value) add_keys(part, out);
  }
}

Plan with_blocks(const std::vector<BlockReport>& blocks) {
  Plan plan = reported_plan();
  plan.blocks = blocks;
  return plan;
}

std::string field_status(const std::vector<BlockReport>& blocks) {
  return Json::parse(report_json(with_blocks(blocks)))["status"];
}

}  // namespace

TEST_CASE("a report names its plan and says what a person must know", "[output][report]") {
  const Json report = Json::parse(report_json(reported_plan()));
  CHECK(keys(report) == std::vector<std::string>{"report", "version", "plan_id", "field", "status",
                                                 "verification", "warnings", "total", "blocks", "assumptions",
                                                 "notes"});
  CHECK(report["report"] == 1);
  CHECK(report["plan_id"] == "0123456789abcdef");
  CHECK(report["field"] == "Pr\u00E8s du bois");
  CHECK(report["warnings"].size() == 2);
  CHECK(report["assumptions"] == Json{"Flat ground", "Boundary accuracy unknown"});
  CHECK(report["notes"] == Json::array({"1 spike removed"}));
}

TEST_CASE("a report says what the independent check found, or that there was none", "[output][report]") {
  Plan plan = reported_plan();
  const auto said = [&] { return Json::parse(report_json(plan))["verification"]; };
  CHECK(said()["verdict"] == "not asked for");
  plan.verification = Verification{};
  CHECK(said()["verdict"] == "passed");
  plan.verification = Verification{{"speed: too fast"}};
  CHECK(said()["verdict"] == "failed");
  CHECK(said()["faults"] == Json::array({"speed: too fast"}));
}

TEST_CASE("the total adds the blocks up", "[output][report]") {
  const Json total = Json::parse(report_json(reported_plan()))["total"];
  CHECK(total["blocks"] == Json{{"planned", 1}, {"partial", 1}, {"refused", 1}});
  CHECK(total["area_m2"] == 91'000);
  CHECK(total["covered_m2"] == 88'599);
  CHECK(total["covered_percent"] == 97.36);  // 88 599 / 91 000
  CHECK(total["uncovered_m2"] == 2401);      // 91 000 - 88 599
  CHECK(total["worked_twice"]["area_m2"] == 1'000);
  CHECK(total["worked_twice"]["percent"] == 1.10);
  CHECK(total["worked_twice"]["corners_m2"] == 300);
  CHECK(total["swaths"]["strips"] == 65);
  CHECK(total["swaths"]["pieces"] == 70);
  CHECK(total["swaths"]["longest_m"] == 378.12);
  CHECK(total["distance"]["total_m"] == 31'500);
  CHECK(total["distance"]["reverse_m"] == 40);
  CHECK(total["distance"]["scrub_m"] == 1.5);
  CHECK(total["pivots"] == 2);
  CHECK(total["time"]["total_s"] == 21'300);
}

TEST_CASE("each block has its status, a refused one its reason and nothing else", "[output][report]") {
  const Json blocks = Json::parse(report_json(reported_plan()))["blocks"];
  CHECK(blocks[0]["status"] == "planned");
  CHECK(blocks[0]["covered_percent"] == 99.5);
  CHECK(blocks[0]["headland"] == Json{{"passes", 3}, {"depth_m", 9.0}, {"turn_depth_m", 6.25}});
  CHECK(blocks[1]["status"] == "partial");
  CHECK(blocks[1]["swaths"] == Json{{"strips", 5}, {"pieces", 5}});  // its only swath in the file is a pocket
  CHECK(blocks[2] == Json{{"number", 3},
                          {"status", "refused"},
                          {"area_m2", 1000.0},
                          {"reason", reported_plan().blocks[2].refused}});
}

TEST_CASE("uncovered places stand with area, a place inside and a closed polygon", "[output][report]") {
  const Json places = Json::parse(report_json(reported_plan()))["blocks"][0]["uncovered"];
  REQUIRE(places.size() == 2);
  CHECK(places[0]["area_m2"] == 250.5);
  CHECK(places[0]["at"] == Json{3.45, 46.35});
  CHECK(places[0]["polygon"]["type"] == "Polygon");
  const Json& ring = places[0]["polygon"]["coordinates"][0];
  CHECK(ring.size() == 4);
  CHECK(ring.front() == ring.back());
}

TEST_CASE("a block is planned from 90 % on, a field by the share of all its blocks", "[output][report]") {
  const std::vector<BlockReport> sample = reported_plan().blocks;
  BlockReport just = sample[1];
  just.covered_m2 = 9'000;
  CHECK(field_status({just}) == "planned");
  CHECK(field_status({sample[1]}) == "partial");
  CHECK(field_status({sample[2]}) == "refused");
  CHECK(field_status({sample[0], sample[2]}) == "planned");  // 79 600 of 81 000
  BlockReport large = sample[2];
  large.area_m2 = 50'000;
  CHECK(field_status({sample[0], large}) == "partial");
}

TEST_CASE("a report is indented and its numbers have fixed decimals", "[output][report]") {
  const std::string text = report_json(reported_plan());
  CHECK_THAT(text, Catch::StartsWith("{\n  \"report\": 1,\n") && Catch::EndsWith("]\n}\n"));
  CHECK_THAT(
      text,
      Catch::Contains(
          "\n    \"area_m2\": 91000.00,\n    \"covered_m2\": 88599.00,\n    \"covered_percent\": 97.36,\n"));
  CHECK_THAT(text, Catch::Contains(
                       "\n        {\"area_m2\": 250.50, \"at\": [3.450000000, 46.350000000], \"polygon\": "));
}

TEST_CASE("a figure that is not finite is never reported", "[output][report]") {
  Plan plan = reported_plan();
  plan.blocks[0].work_s = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(report_json(plan), std::logic_error);
}

TEST_CASE("docs/report.md describes every member of a report", "[output][report]") {
  std::ifstream file{project_dir() / "docs/report.md"};
  REQUIRE(file);
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  std::set<std::string> members;
  add_keys(Json::parse(report_json(reported_plan())), members);
  CHECK(members.size() > 35);
  for (const std::string& member : members) CHECK_THAT(page, Catch::Contains("`" + member + "`"));
}
