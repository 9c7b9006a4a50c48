// SPDX-License-Identifier: GPL-3.0-or-later
// Plans against their owner's file.
#include "test.hpp"

#include <algorithm>
#include <iostream>

#include "field_samples.hpp"
#include "selion/core/error.hpp"
#include "verify_samples.hpp"

using namespace selion;

namespace {

const char* const kField = "{}";

Ring box(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

Ring field_ring() { return box(0, 0, 80, 60); }

/// What the check says of the plan that is made of one file, against another.
std::string codes(const std::string& planned, const std::string& owned) {
  const TemporaryFile given{"owned.geojson", owned};
  const TemporaryFile source{"planned.geojson", planned};
  const PlanFile plan = written(read_file(source.path()).at(0), "", Repair::accept);
  return text_of(verify(plan, GivenField{.file = given.path()}));
}

std::string codes(const std::string& file) { return codes(file, file); }

}  // namespace

TEST_CASE("a plan is held against its owner's field", "[verify]") {
  const PlanFile plan = written(sample("with_pond.geojson"), "");
  const auto against = [&](const char* name) { return verify(plan, GivenField{.file = sample_file(name)}); };
  CHECK(text_of(against("with_pond.geojson")) == "");
  CHECK(text_of(against("f1.zip")) != "");
  CHECK_THROWS_AS(against("SOURCES.md"), InputError);
}

TEST_CASE("ground of the plan that its owner's field lacks, or has and the plan not, is found", "[verify]") {
  const auto codes_against = [](const Field& planned, const char* name) {
    return text_of(verify(written(planned, ""), GivenField{.file = sample_file(name)}));
  };
  Field no_pond = sample("with_pond.geojson");
  for (LonLatPolygon& part : no_pond.parts) part.holes.clear();
  no_pond.obstacles.clear();
  CHECK(codes_against(no_pond, "with_pond.geojson").find("given_") != std::string::npos);
  Field half = sample("two_parts.geojson");
  half.parts.resize(1);
  CHECK(codes_against(half, "two_parts.geojson").find("given_left_out") != std::string::npos);
  CHECK(codes_against(sample("f1.geojson"), "l_shape.geojson") != "");
}

TEST_CASE("rings that cross or overlap enclose for the check what they do for the planner", "[verify]") {
  const std::vector<Polygon> parts = GENERATE(values<std::vector<Polygon>>({
      {{box(0, 0, 80, 60), {box(30, 20, 40, 30), box(35, 25, 45, 35)}}},
      {{box(0, 0, 80, 60), {box(30, 20, 50, 40), box(35, 25, 45, 35)}}},
      {{box(0, 0, 80, 60), {box(60, 20, 95, 40)}}},
      {{box(0, 0, 80, 60), {box(100, 20, 115, 40)}}},
      {{box(0, 0, 80, 60), {box(60, 20, 80, 40)}}},
      {{box(0, 0, 80, 60), {}}, {box(60, 20, 120, 50), {}}},
      {{box(0, 0, 80, 60), {}}, {box(20, 20, 50, 50), {}}},
      {{box(0, 0, 80, 60), {box(20, 10, 60, 50)}}, {box(30, 20, 50, 40), {}}},
      // A loop outside, a loop that goes round the same ground once more, a star, a bridge to a hole.
      {{{{0, 0}, {80, 0}, {80, 60}, {40, 60}, {60, 90}, {20, 90}, {40, 50}, {0, 60}}, {}}},
      {{{{0, 0}, {80, 0}, {80, 60}, {30, 60}, {30, 20}, {60, 20}, {60, 40}, {0, 40}}, {}}},
      {{{{50, 0}, {79, 90}, {2, 35}, {98, 35}, {21, 90}}, {}}},
      {{{{0, 0},
         {80, 0},
         {80, 60},
         {40, 60},
         {40, 40},
         {50, 40},
         {50, 30},
         {30, 30},
         {30, 40},
         {40, 40},
         {40, 60},
         {0, 60}},
        {}}},
      // A hole whose ring crosses itself.
      {{box(0, 0, 80, 60), {{{30, 20}, {50, 40}, {50, 20}, {30, 40}}}}},
  }));
  CHECK(codes(collection_of({feature_of(parts, kField)})) == "");
}

TEST_CASE("what repairs move by a centimetre is no fault, a pole and a hand's width of ground are",
          "[verify]") {
  const auto against = [](const Polygon& owned) {
    return codes(collection_of({feature_of({{field_ring(), {}}}, kField)}),
                 collection_of({feature_of({owned}, kField)}));
  };
  CHECK(against({box(0, 0, 80, 59.99), {}}) == "");
  CHECK(against({box(0, 0, 80, 60), {box(40, 30, 48, 30.01)}}) == "");
  CHECK_THAT(against({box(0, 0, 80, 59.95), {}}), Catch::StartsWith("given_outside: 4.00 m2"));
  CHECK_THAT(against({box(0, 0, 80, 60), {box(40, 30, 40.06, 30.06)}}),
             Catch::StartsWith("given_outside: 0.0036 m2"));
}

TEST_CASE("a feature is what its property selion says, however that is written", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}}, R"({"selion":"Field"})");
  const auto with = [&](const std::string& word) {
    return collection_of({field, feature_of({{box(30, 20, 40, 30), {}}}, R"({"selion":")" + word + R"("})")});
  };
  const std::string alone = collection_of({field});
  CHECK(codes(alone) == "");
  for (const char* word : {"obstacle", "Obstacles", "no-go", "No_Go", "nogo", "WATER"}) {
    CAPTURE(word);
    CHECK(codes(with(word)) == "");
    CHECK_THAT(codes(alone, with(word)), Catch::StartsWith("given_obstacle: 100.00 m2"));
  }
  const std::string shouted = collection_of(
      {field, feature_of({{box(30, 20, 40, 30), {}}}, R"({"Selion":"Obstacle"})"),
       feature_of(Point{60, 40}, R"({"SELION":"obstacle","Radius_M":2})"),
       feature_of(std::vector<Point>{{10, 10}, {20, 10}}, R"({"selion":"obstacle","WIDTH_M":3})")});
  CHECK(codes(shouted) == "");
  for (const char* area : {"100.00 m2", "12.49 m2", "30.00 m2"})
    CHECK_THAT(codes(alone, shouted), Catch::Contains(area));
  CHECK_THROWS_WITH(codes(alone, with("pond")), Catch::Contains("feature 2") && Catch::Contains("'pond'"));
}

TEST_CASE("obstacles given as points and lines are held against the plan", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}}, kField);
  const std::string alone = collection_of({field});
  const auto with = [&](const std::string& obstacle) { return collection_of({field, obstacle}); };
  const std::string pole = with(feature_of(Point{40.5, 30}, R"({"selion":"obstacle","radius_m":0.03})"));
  const std::string pylon =
      with(feature_of(Point{40, 30}, R"({"selion":"no_go","radius_m":"2.5","name":"pylon"})"));
  const std::string wire =
      with(feature_of(std::vector<Point>{{30, 20}, {50, 20}, {50, 40}}, R"({"selion":"obstacle"})"));
  const std::string road = with(
      feature_of(std::vector<Point>{{20, -5}, {20, 30}, {45, 30}}, R"({"selion":"obstacle","width_m":4})"));
  for (const std::string& file : {pole, pylon, wire, road}) {
    CHECK(codes(file) == "");
    CHECK_THAT(codes(alone, file), Catch::StartsWith("given_obstacle"));
  }
  CHECK_THAT(codes(alone, pylon),
             Catch::Contains("19.51 m2 of the plan's ground lie in the obstacle 'pylon'"));
  // 20 m and 20 m of 2 cm.
  CHECK_THAT(codes(alone, wire), Catch::Contains("0.80 m2 of the plan's ground lie in the obstacle"));
  CHECK_THROWS_WITH(codes(alone, with(feature_of(Point{40, 30}, R"({"selion":"obstacle"})"))),
                    Catch::Contains("radius_m"));
}

TEST_CASE("an obstacle beside the field counts as far as the machine keeps off it", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}}, kField);
  const std::string job = "[field]\nwater_margin_m = 3\n";
  const auto text = [&](const std::string& planned, const std::string& owned) {
    const TemporaryFile given{"owned.geojson", owned};
    const TemporaryFile source{"planned.geojson", planned};
    return text_of(verify(written(read_file(source.path()).at(0), job), GivenField{.file = given.path()}));
  };
  const std::string ditch =
      collection_of({field, feature_of({{box(10, -4, 70, -1), {}}}, R"({"selion":"water"})")});
  CHECK(text(ditch, ditch) == "");
  CHECK_THAT(text(collection_of({field}), ditch),
             Catch::StartsWith("given_obstacle") && Catch::Contains("within 3.00 m of the obstacle"));
}

TEST_CASE("a finding against the owner's field tells the place", "[verify]") {
  const TemporaryFile planned{"planned.geojson", collection_of({feature_of({{field_ring(), {}}}, kField)})};
  const TemporaryFile obstacles{
      "obstacles.geojson", collection_of({feature_of(Point{30, 40}, R"({"radius_m":1})"),
                                          feature_of({{box(60, 10, 64, 14), {}}}, R"({"selion":"field"})")})};
  const PlanFile plan = written(read_file(planned.path()).at(0), "");
  const Verdict verdict = verify(plan, GivenField{.file = planned.path(), .obstacles = obstacles.path()});
  REQUIRE(verdict.findings.size() == 2);
  const LonLatRing places = polygon_of_metres({{{30, 40}, {62, 12}}, {}}).shell;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Finding& finding = verdict.findings[i];
    CHECK(finding.code == "given_obstacle");
    REQUIRE(finding.at.has_value());
    CHECK(finding.at->lon_deg == Approx(places[i].lon_deg).margin(1e-5).epsilon(0));
    CHECK(finding.at->lat_deg == Approx(places[i].lat_deg).margin(1e-5).epsilon(0));
  }
}

TEST_CASE("gates are those of the owner's file: place, name, width, number", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}}, kField);
  const auto gate = [](Point at, const std::string& more) {
    return feature_of(at, R"({"selion":"gate")" + more + "}");
  };
  const std::string south = gate({20, -3}, R"(,"name":"south","width_m":6)");
  const std::string north = gate({50, 62}, R"(,"name":7)");
  const std::string far = gate({50, 90}, "");
  const std::string file = collection_of({field, south, north, far});
  CHECK(codes(file) == "");
  const auto against = [&](const std::vector<std::string>& gates) {
    std::vector<std::string> features{field};
    features.insert(features.end(), gates.begin(), gates.end());
    return codes(file, collection_of(features));
  };
  CHECK(against({south, north}) == "");
  for (const std::string& other :
       {gate({20.5, -3}, R"(,"name":"south","width_m":6)"), gate({20, -3}, R"(,"name":"south","width_m":4)"),
        gate({20, -3}, R"(,"name":"south")"), gate({20, -3}, R"(,"name":"west","width_m":6)")})
    CHECK_THAT(against({other, north}), Catch::StartsWith("given_gate: the owner's gate"));
  CHECK_THAT(against({north, south}), Catch::Contains("given_gate"));
  CHECK_THAT(against({south}), Catch::StartsWith("given_gate: the plan's gate '7'"));
  CHECK_THAT(codes(collection_of({field, south}), file),
             Catch::StartsWith("given_gate: the owner's gate '7'"));
}

TEST_CASE("gates of a file of their own are read with it", "[verify]") {
  const TemporaryFile field{"field.geojson", collection_of({feature_of({{field_ring(), {}}}, kField)})};
  const TemporaryFile gates{"gates.geojson", collection_of({feature_of(Point{20, -3}, R"({"width_m":4})")})};
  ReadOptions options;
  options.gates = gates.path();
  const PlanFile plan = written(read_fields(field.path(), options, std::cin).at(0), "", Repair::notes_only);
  REQUIRE(plan.gates.size() == 1);
  CHECK(text_of(verify(plan, GivenField{.file = field.path(), .gates = gates.path()})) == "");
  CHECK_THAT(text_of(verify(plan, GivenField{.file = field.path()})),
             Catch::StartsWith("given_gate") && Catch::Contains("--gates"));
}

TEST_CASE("an obstacle is of the kind that it has in the owner's file", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}}, kField);
  const auto with = [&](const std::string& kind) {
    return collection_of({field, feature_of({{box(30, 20, 40, 30), {}}}, R"({"selion":")" + kind + R"("})")});
  };
  CHECK_THAT(codes(with("water"), with("obstacle")),
             Catch::Contains("is said to be water; the owner's is obstacle"));
  CHECK_THAT(codes(with("no_go"), with("obstacle")),
             Catch::Contains("is said to be no_go; the owner's is obstacle"));
  CHECK_THAT(codes(with("obstacle"), collection_of({field})), Catch::Contains("the owner has none there"));
}

TEST_CASE("an obstacle is called as in the owner's file, and is there once", "[verify]") {
  const auto with = [&](const std::string& name) {
    return collection_of(
        {feature_of({{field_ring(), {}}}, kField),
         feature_of({{box(30, 20, 40, 30), {}}}, R"({"selion":"obstacle","name":")" + name + R"("})")});
  };
  CHECK(codes(with("pole")) == "");
  CHECK_THAT(codes(with("pole"), with("pond")), Catch::Contains("'pole'; the owner's is obstacle, 'pond'"));
  const TemporaryFile owned{"owned.geojson", with("pole")};
  PlanFile plan = written(read_file(owned.path()).at(0), "", Repair::accept);
  plan.obstacles.push_back(plan.obstacles.front());
  CHECK_THAT(text_of(verify(plan, GivenField{.file = owned.path()})), Catch::Contains("more than once"));
}

TEST_CASE("a gate nearer to an obstacle than to the border is at the border", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}}, kField);
  const std::string gate = feature_of(Point{40, 2}, R"({"selion":"gate","name":"N"})");
  const std::string post = feature_of(Point{42, 2.2}, R"({"selion":"obstacle","radius_m":0.1})");
  CHECK(codes(collection_of({field, gate, post})) == "");
}

TEST_CASE("what stands in a block that is not planned is kept off anyway", "[verify]") {
  const std::string field = feature_of({{field_ring(), {}}, {box(100, 20, 109, 32), {}}}, kField);
  const std::string tree = feature_of(Point{104.5, 26}, R"({"selion":"obstacle","radius_m":0.4})");
  CHECK(codes(collection_of({field, tree})) == "");
  const std::string near = feature_of(Point{40, 30}, R"({"selion":"obstacle","radius_m":0.4})");
  CHECK(codes(collection_of({field, tree}), collection_of({field, tree, near})) != "");
}
