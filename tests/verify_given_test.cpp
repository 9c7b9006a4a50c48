// SPDX-License-Identifier: GPL-3.0-or-later
// Plans against their owner's file.
#include "test.hpp"

#include <algorithm>

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
  CHECK_THROWS_WITH(codes(alone, with("pond")), Catch::Contains("feature 2") && Catch::Contains("'pond'"));
}
