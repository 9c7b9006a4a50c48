// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <string>
#include <vector>

#include "planfile_samples.hpp"
#include "selion/core/error.hpp"
#include "selion/planfile/planfile.hpp"

using namespace selion;

namespace {

struct Broken {
  std::string from;  // the first place of this in the sample's text
  std::string to;
  std::vector<std::string> words;  // that the message must hold
};

std::string message(const std::string& text) {
  try {
    plan_from_geojson(text, "fields/plan.geojson");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a broken plan file is refused with its place", "[planfile][errors]") {
  const auto broken = GENERATE(values<Broken>({
      {"FeatureCollection", "Feature", {"type", "FeatureCollection"}},
      {"\"type\": \"FeatureCollection\",", "", {"\"type\" is missing"}},
      {"\"selion\": {", "\"other\": {", {"no plan", "\"selion\" is missing", "selion plan"}},
      {"\"format\": 1", "\"format\": 2", {"\"selion.format\"", "is 2", "reads format 1"}},
      {"\"format\": 1", "\"format\": \"1\"", {"\"selion.format\"", "whole number", "string"}},
      {"0123456789abcdef", "hello", {"\"selion.id\"", "16 hexadecimal digits"}},
      {"\"version\": \"0.1.0\"", "\"version\": null", {"\"selion.version\"", "must be a string", "null"}},
      {"\"origin\": [3.409400000, 46.336700000]",
       "\"origin\": [46.3, 123.4]",
       {"\"selion.frame.origin\"", "123.4", "[longitude, latitude]"}},
      {"+proj=tmerc", "+nadgrids=a.gsb +proj=tmerc", {"\"selion.frame.proj\"", "names a file"}},
      {"+proj=tmerc", "+proj=tmerc +x=a/b", {"\"selion.frame.proj\"", "characters"}},
      {"+proj=tmerc", "+proj=tmerc" + std::string(1000, ' '), {"\"selion.frame.proj\"", "longer than 1000"}},
      {"\"job\": {", "\"jobs\": {", {"\"selion.job\" is missing"}},
      {"\"job\": ", "\"job\": 3, \"x\": ", {"\"selion.job\"", "must be an object"}},
      {"\"covered_m2\": 50912.2500",
       "\"covered_m2\": \"much\"",
       {"\"selion.summary.covered_m2\"", "must be a number"}},
      {"\"summary\": {", "\"summary\": [], \"x\": {", {"\"selion.summary\"", "must be an object"}},
      {"\"covered_m2\": 50912.2500", "\"area_m2\": 1", {"\"selion.summary.area_m2\"", "twice"}},
      {"\"format\": 1", "\"format\": 1, \"format\": 1", {"\"selion.format\"", "twice"}},
      {"\"job\": {", "\"job\": {\"x\": {\"a\": 1, \"b\": 2, \"a\": 1}, ", {"\"selion.job.x.a\"", "twice"}},
      {"\"kind\": \"field\"",
       "\"kind\": \"gate\", \"kind\": \"field\"",
       {"\"features[0].properties.kind\"", "twice"}},
      {"\"features\": [", "\"crs\": null, \"features\": [", {"\"crs\"", "WGS84"}},
      {"\"properties\": {\"kind\": \"field\"",
       "\"crs\": {}, \"properties\": {\"kind\": \"field\"",
       {"feature 1", "\"crs\""}},
      {"\"warnings\": [", "\"warnings\": [7, ", {"\"selion.warnings[0]\"", "must be a string, not 7"}},
      {"\"features\": [", "\"features\": 1, \"x\": [", {"\"features\"", "must be an array, not 1"}},
      {"\"features\": [", "\"features\": [null, ", {"feature 1", "must be an object, not null"}},
      {"\"kind\": \"field\"",
       "\"kind\": \"fields\"",
       {"feature 1:", "properties.kind", "fields", "does not know", "0.1.0"}},
      {"\"kind\": \"field\"", "\"kind\": \"tramline\"", {"feature 1:", "tramline", "does not read yet"}},
      {"\"kind\": \"field\", ", "", {"feature 1", "\"properties.kind\" is missing"}},
      {"\"area_m2\": 51000.5000, ", "", {"feature 1 (field)", "\"properties.area_m2\" is missing"}},
      {"[[[[3.409000000, 46.336000000]",
       "[[[[3.4, 46.3]",
       {"feature 1 (field)", "geometry.coordinates[0][0]", "not closed"}},
      {"\"MultiPolygon\"",
       "\"Point\"",
       {"feature 1 (field)", "\"geometry\"", "must be a Polygon, not a Point"}},
      {"\"block\": 1, \"name\": \"pond\"",
       "\"block\": 0, \"name\": \"pond\"",
       {"feature 2 (obstacle)", "block", "at least 1, not 0"}},
      {"\"block\": 1, \"name\": \"pond\"",
       "\"block\": 1.5, \"name\": \"pond\"",
       {"feature 2 (obstacle)", "block", "whole", "1.5"}},
      {"\"what\": \"water\"", "\"what\": \"lava\"", {"feature 2 (obstacle)", "lava", "no_go"}},
      {"[3.409000000, 46.336500000]",
       "[3.409, 146.3365]",
       {"feature 4 (gate)", "geometry.coordinates", "146.3365"}},
      {"[3.409000000, 46.336500000]", "[3.409, 46.3, 7]", {"feature 4 (gate)", "a position"}},
      {"\"width_m\": 4.5000", "\"width_m\": null", {"feature 4 (gate)", "\"properties.width_m\"", "null"}},
      {"\"width_m\": 4.5000", "\"width_m\": 1e999", {"1e999"}},
      {"\"width_m\": 4.5000", "\"width_m\": NaN", {"byte ", "not JSON"}},
      {"[3.409200000, 46.339900000]]", "[3.4, 46.3], [3.5, 46.3]]", {"feature 8 (ab)", "2 positions, not 3"}},
      {"\"order\": 7, ", "", {"feature 11 (swath)", "\"properties.order\" is missing"}},
      {"[[3.410000000, 46.336300000], [3.410000000, 46.339700000]]",
       "[[3.4, 46.3]]",
       {"feature 11 (swath)", "1 positions, it needs 2"}},
      {"[[3.410000000, 46.336300000], ",
       "[[3.41, \"46\"], ",
       {"feature 11 (swath)", "geometry.coordinates[0]", "a position"}},
      {"\"robot\": 1, ", "", {"feature 13 (trajectory)", "\"properties.robot\" is missing"}},
      {"\"pieces\": [", "\"pieces\": [], \"x\": [", {"feature 13 (trajectory)", "pieces is empty"}},
      {"\"pieces\": [{\"kind\": \"swath\"",
       "\"pieces\": [{\"kind\": \"hop\"",
       {"feature 13", "\"properties.pieces[0]\"", "hop", "headland_pass"}},
      {", 30.000000000]", "]", {"\"properties.pieces[0].curve\"", "5 numbers, it needs 6"}},
      {", 30.000000000]", ", -30]", {"\"properties.pieces[0]\"", "length", "negative"}},
      {"\"gear\": -1", "\"gear\": 0", {"\"properties.pieces[2]\"", "gear is 0", "1 or -1"}},
      {"\"gear\": -1, ", "", {"\"properties.pieces[2].gear\" is missing"}},
      {"\"angle_rad\": 1.57079633, ", "", {"\"properties.pieces[3]\"", "a pivot needs angle_rad"}},
      {", \"for_robot\": 2", "", {"\"properties.pieces[4]\"", "for_robot and until_station_m"}},
      {"\"t_s\": [0.0000, ",
       "\"t_s\": [",
       {"feature 13 (trajectory)", "t_s has 2 entries, there are 3 coordinates"}},
      {"\"t_s\": [0.0000, ",
       "\"t_s\": [false, ",
       {"feature 13", "\"properties.t_s[0]\"", "must be a number, not false"}},
      {"\"heading_rad\": [", "\"heading_rad\": [0, ", {"heading_rad has 4 entries"}},
      {"\"tool\": [1, ", "\"tool\": [2, ", {"feature 13", "tool holds 2"}},
      {"\"tool\": [1, ", "\"tool\": [0.5, ", {"feature 13", "\"properties.tool[0]\"", "whole"}},
  }));
  const std::string said = message(replaced(to_geojson(sample_plan()), broken.from, broken.to));
  CAPTURE(broken.from, broken.to, said);
  CHECK(said.starts_with("fields/plan.geojson: "));
  for (const std::string& word : broken.words) CHECK_THAT(said, Catch::Contains(word));
}

TEST_CASE("a file that is cut short anywhere is refused and the byte is named", "[planfile][errors]") {
  const std::string text = to_geojson(sample_plan());
  const std::size_t last = text.rfind('}');
  for (std::size_t length = 0; length <= last; length += 61) {
    const std::string said = message(text.substr(0, length));
    CAPTURE(length, said);
    CHECK_THAT(said, Catch::Contains("byte " + std::to_string(length + 1)) && Catch::Contains("cut short"));
  }
}

TEST_CASE("what is not JSON or not a collection is refused", "[planfile][errors]") {
  CHECK_THAT(message("<kml/>"), Catch::Contains("byte 1: this is not JSON"));
  CHECK_THAT(message("[]"), Catch::Contains("must be an object, not of type array"));
  CHECK_THAT(message(to_geojson(sample_plan()) + "x"), Catch::Contains("not JSON"));
  const std::string behind_nul = to_geojson(sample_plan()) + std::string{"\0x", 2};
  CHECK_THAT(message(behind_nul),
             Catch::Contains("byte " + std::to_string(behind_nul.size() - 1) + ": this is not JSON"));
  CHECK_THAT(message(std::string(1000, '[')),
             Catch::Contains("byte 1001 (the end of the file: it is cut short)"));
}

TEST_CASE("brackets without end are refused where they get too deep", "[planfile][errors]") {
  const std::string bracket = GENERATE("[", "{\"a\":");
  std::string text;
  for (int i = 0; i < 1'000'000; ++i) text += bracket;  // a tree of them would take 100 MB
  CHECK_THAT(message(text), Catch::Contains("nest too deeply"));
}
