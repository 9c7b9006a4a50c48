// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include "field_samples.hpp"
#include "selion/field/stream.hpp"

using namespace selion;

namespace {

/// A feature beside the field: its geometry's type, coordinates and properties.
std::string feature(const std::string& type, const std::string& coordinates, const std::string& properties) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}}";
}

std::string beside_field(const std::string& extra) {
  return R"({"type":"FeatureCollection","features":[)" +
         feature("Polygon", "[[[10,50],[10.001,50],[10.001,50.001],[10,50.001],[10,50]]]", "{}") + "," +
         extra + "]}";
}

std::string error_with(const std::string& extra) {
  return error_of([&] { read_stdin(beside_field(extra)); });
}

const std::string kObstacle = R"({"selion":"obstacle"})";
const std::string kTriangle = "[[[10.0002,50.0002],[10.0004,50.0002],[10.0004,50.0004],[10.0002,50.0002]]]";

}  // namespace

TEST_CASE("an obstacle without area or length is refused by place", "[field][extras]") {
  const std::string flat = "[[[10.0002,50.0002],[10.0003,50.0002],[10.0004,50.0002],[10.0002,50.0002]]]";
  const std::string message = error_with(feature("Polygon", flat, kObstacle));
  CHECK(mentions(message, "feature 2 is an obstacle without area"));
  CHECK(mentions(message, "near 10.0002000 E, 50.0002000 N"));
  CHECK(mentions(error_with(feature("MultiPolygon", "[" + kTriangle + "," + flat + "]", kObstacle)),
                 "feature 2, part 2 is an obstacle without area"));
  CHECK(mentions(error_with(feature("LineString", "[[10.0002,50.0002],[10.0002,50.0002]]", kObstacle)),
                 "feature 2 is an obstacle without length"));
  // its loops cancel each other out, and are there
  CHECK(error_with(feature(
            "Polygon",
            "[[[10.0002,50.0002],[10.0004,50.0004],[10.0004,50.0002],[10.0002,50.0004],[10.0002,50.0002]]]",
            kObstacle)) == "");
}

TEST_CASE("an obstacle or gate larger than any field is refused by value", "[field][extras]") {
  for (const char* radius : {"10001", "1e9", "1e308"}) {
    CAPTURE(radius);
    const std::string message =
        error_with(feature("Point", "[10.0005,50.0005]",
                           R"({"selion":"obstacle","radius_m":")" + std::string{radius} + R"("})"));
    CHECK(mentions(message, "feature 2: its radius_m is '" + std::string{radius} + "', more than 10 km"));
  }
  CHECK(mentions(error_with(feature("Point", "[10.0005,50]", R"({"selion":"gate","width_m":1e6})")),
                 "width_m"));
  CHECK(error_with(feature("Point", "[10.0005,50.0005]", R"({"selion":"obstacle","radius_m":10000})")) == "");
}

TEST_CASE("a role, a radius and a width are read in any case", "[field][extras]") {
  const std::vector<Field> fields =
      read_stdin(beside_field(feature("Polygon", kTriangle, R"({"Selion":"Obstacle","name":"barn"})") + "," +
                              feature("Point", "[10.0006,50.0006]", R"({"SELION":"NO_GO","Radius_M":2})") +
                              "," + feature("Point", "[10.0005,50]", R"({"SeLiOn":"gate","WIDTH_M":6})")));
  REQUIRE(fields.size() == 1);
  REQUIRE(fields.front().obstacles.size() == 2);
  CHECK(fields.front().obstacles.front().name == "barn");
  CHECK(fields.front().obstacles.back().kind == ObstacleKind::no_go);
  REQUIRE(fields.front().gates.size() == 1);
  CHECK(fields.front().gates.front().width_m == 6.0);
  CHECK(mentions(error_with(feature("Polygon", kTriangle, R"({"SELION":"barn"})")), "'barn'"));
}

TEST_CASE("an obstacle or gate without geometry is an error, a feature without role is skipped",
          "[field][extras]") {
  const auto without = [](const std::string& geometry, const std::string& properties) {
    return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" + geometry + "}";
  };
  const std::string empty = R"({"type":"Polygon","coordinates":[]})";
  CHECK(mentions(error_with(without("null", kObstacle)), "feature 2 is an obstacle, but has no geometry"));
  CHECK(mentions(error_with(without(empty, R"({"selion":"water"})")), "feature 2 is water, but has"));
  CHECK(mentions(error_with(without("null", R"({"selion":"gate"})")), "feature 2 is a gate, but has"));
  CHECK(any_mentions(read_stdin(beside_field(without("null", "{}"))).front().notes, "skipped"));
  const TemporaryFile poles{"poles.geojson", without("null", "{}")};
  ReadOptions options;
  options.obstacles = poles.path();
  const std::string field = beside_field(feature("Point", "[10,50]", "{}"));
  CHECK(mentions(error_of([&] { read_stdin(field, options); }),
                 "feature 1 is an obstacle, but has no geometry"));
  // one at a time too, as a batch reads
  const TemporaryFile file{"field.geojson", beside_field(without("null", kObstacle))};
  CHECK(mentions(error_of([&] { FieldStream{file.path(), {}}; }), "has no geometry"));
}
