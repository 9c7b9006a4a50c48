// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <string>

#include "planfile/json_value.hpp"
#include "planfile_samples.hpp"
#include "selion/planfile/planfile.hpp"

using namespace selion;

TEST_CASE("what the writer makes of ASCII is read the short way", "[planfile][json]") {
  PlanFile plan = sample_plan();
  plan.warnings.clear();
  plan.job_json = "{}";
  for (FieldRecord& field : plan.fields) field.name = "home", field.notes.clear();
  for (ObstacleRecord& obstacle : plan.obstacles) obstacle.name = "pond";
  for (GateRecord& gate : plan.gates) gate.name = "east";
  CHECK(plain_values(to_geojson(plan)));
}

TEST_CASE("both ways of reading read the same", "[planfile][json]") {
  const std::string text = to_geojson(sample_plan());
  const std::string escaped = replaced(text, R"("FeatureCollection")", R"("Feature\u0043ollection")");
  CHECK_FALSE(plain_values(escaped));
  CHECK(plan_from_geojson(text, "plain") == plan_from_geojson(escaped, "escaped"));
}

TEST_CASE("the short way leaves what is not plain JSON to the library", "[planfile][json]") {
  const char* text =
      GENERATE("", " ", "[", "[1,]", "[1 2]", "{\"a\" 1}", "{\"a\":1,}", "{a:1}", "01", "+1", "1.", ".5",
               "1e", "1e400", "1e-400", "nul", "tru", "\"a", "\"a\\n\"", "\"\x7f\"", "\"\t\"", "\"\xc3\xa4\"",
               "1 x", "NaN", "-", "--1", "{\"a\":}", "[]]");
  CAPTURE(text);
  CHECK_FALSE(plain_values(text));
}

TEST_CASE("a value knows how many stand inside it", "[planfile][json]") {
  const auto values = plain_values(R"( {"a": [1, -0, 2.5e1, {}], "b": true, "c": "x", "d": null} )");
  REQUIRE(values);
  REQUIRE(values->size() == 9);
  CHECK(values->at(0).all == 9);
  CHECK(values->at(1).all == 5);
  CHECK(values->at(1).key == "a");
  CHECK(values->at(2).kind == JsonKind::whole);
  CHECK_FALSE(std::signbit(values->at(3).number));
  CHECK(values->at(4).number == 25);
  CHECK(values->at(4).kind == JsonKind::number);
  CHECK(values->at(6).kind == JsonKind::boolean);
  CHECK(values->at(7).text == "x");
  CHECK(values->at(8).kind == JsonKind::null);
}
