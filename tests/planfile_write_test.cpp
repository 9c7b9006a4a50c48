// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <clocale>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "planfile_samples.hpp"
#include "selion/planfile/planfile.hpp"

using namespace selion;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The line of the first feature of `kind`.
std::string feature(const std::string& text, const std::string& kind) {
  std::istringstream lines{text};
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"kind\": \"" + kind + "\"") != std::string::npos &&
        line.find("\"Feature\"") != std::string::npos)
      return line;
  }
  FAIL("no feature of kind " << kind);
  return {};
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

struct CommaPoint : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

using Spoil = void (*)(PlanFile&);

}  // namespace

TEST_CASE("every feature stands on a line of its own", "[planfile][write]") {
  const std::string text = to_geojson(sample_plan());
  CHECK(text.starts_with("{\n  \"type\": \"FeatureCollection\",\n  \"selion\": {\n    \"format\": 1,\n"));
  CHECK(count_of(text, "\"Feature\"") == 14);
  CHECK(count_of(text, "\n    {\"type\": \"Feature\", ") == 14);
  CHECK(text.ends_with("}\n  ]\n}\n"));
}

TEST_CASE("records are written with the decimals of the schema", "[planfile][write]") {
  const std::string text = to_geojson(sample_plan());
  CHECK(
      feature(text, "gate") ==
      R"(    {"type": "Feature", "properties": {"kind": "gate", "block": 1, "name": "north", "width_m": 4.5000}, )"
      R"("geometry": {"type": "Point", "coordinates": [3.409000000, 46.336500000]}},)");
  CHECK(
      feature(text, "swath") ==
      R"(    {"type": "Feature", "properties": {"kind": "swath", "block": 1, "id": "12a", "cell": "1", "order": 7, )"
      R"("width_m": 3.0000, "length_m": 378.1234}, "geometry": {"type": "LineString", )"
      R"("coordinates": [[3.410000000, 46.336300000], [3.410000000, 46.339700000]]}},)");
  const std::string trajectory = feature(text, "trajectory");
  CHECK(
      trajectory.find(
          R"("curve": [-12.500000000, 3.123456789, 0.785398163397, 0.000000000000, 0.000000000000, 30.000000000])") !=
      std::string::npos);
  CHECK(
      trajectory.find(
          R"("curvature_per_m": [0.00000000, 0.25000000, -0.12345678], "speed_mps": [0.0000, 1.5000, -0.5000], )"
          R"("tool": [1, 0, 0]}, "geometry")") != std::string::npos);
}

TEST_CASE("no zero has a sign", "[planfile][write]") {
  PlanFile plan = sample_plan();
  plan.trajectories.front().speed_mps = {-0.0, -0.00001, -1e-300};
  plan.gates.front().at = {-0.0, -1e-12};
  const std::string text = to_geojson(plan);
  CHECK(text.find("-0.0000,") == std::string::npos);
  CHECK(text.find("-0.000000000]") == std::string::npos);
  CHECK(text.find("[0.0000, 0.0000, 0.0000]") != std::string::npos);
}

TEST_CASE("shells are anticlockwise, holes clockwise, rings closed", "[planfile][write]") {
  PlanFile plan = sample_plan();
  const LonLatLine anticlockwise = {{3, 46}, {4, 46}, {4, 47}};
  const LonLatLine clockwise = {{3, 46}, {4, 47}, {4, 46}};
  const std::string shell =
      "[[3.000000000, 46.000000000], [4.000000000, 46.000000000], [4.000000000, 47.000000000], [3.000000000, "
      "46.000000000]]";
  const std::string hole =
      "[[3.000000000, 46.000000000], [4.000000000, 47.000000000], [4.000000000, 46.000000000], [3.000000000, "
      "46.000000000]]";
  for (const LonLatLine& ring : {anticlockwise, clockwise}) {
    plan.headlands.front().parts = {{ring, {ring}}};
    CHECK(feature(to_geojson(plan), "headland")
              .find("\"Polygon\", \"coordinates\": [" + shell + ", " + hole + "]}") != std::string::npos);
  }
}

TEST_CASE("what no reader could take is never written", "[planfile][write]") {
  const auto spoil = GENERATE(
      Spoil{[](PlanFile& p) { p.gates[0].at.lon_deg = kNaN; }},
      Spoil{[](PlanFile& p) { p.gates[0].at.lat_deg = 91; }},
      Spoil{[](PlanFile& p) { p.gates[0].block = 0; }}, Spoil{[](PlanFile& p) { p.gates[0].width_m = kNaN; }},
      Spoil{[](PlanFile& p) { p.fields[0].parts.clear(); }},
      Spoil{[](PlanFile& p) { p.fields[0].area_m2 = kNaN; }},
      Spoil{[](PlanFile& p) { p.fields[0].parts[0].holes[0].resize(2); }},
      Spoil{[](PlanFile& p) { p.swaths[0].line.resize(1); }},
      Spoil{[](PlanFile& p) { p.swaths[0].order = -1; }},
      Spoil{[](PlanFile& p) { p.obstacles[0].what = "tree"; }},
      Spoil{[](PlanFile& p) { p.summary[0].value = kNaN; }},
      Spoil{[](PlanFile& p) { p.summary[1].key = p.summary[0].key; }},
      Spoil{[](PlanFile& p) { p.summary[0].key = "a \"b\""; }},
      Spoil{[](PlanFile& p) { p.job_json = "{\"a\":}"; }}, Spoil{[](PlanFile& p) { p.job_json = "[]"; }},
      Spoil{[](PlanFile& p) { p.format = 2; }}, Spoil{[](PlanFile& p) { p.trajectories[0].t_s.pop_back(); }},
      Spoil{[](PlanFile& p) { p.trajectories[0].tool[0] = 2; }},
      Spoil{[](PlanFile& p) { p.trajectories[0].heading_rad[1] = kNaN; }},
      Spoil{[](PlanFile& p) { p.trajectories[0].pieces.clear(); }},
      Spoil{[](PlanFile& p) { p.trajectories[0].pieces[0].gear = 0; }},
      Spoil{[](PlanFile& p) { p.trajectories[0].pieces[0].kind = "hop"; }},
      Spoil{[](PlanFile& p) { p.trajectories[0].pieces[0].length_m = -1; }},
      Spoil{[](PlanFile& p) { p.trajectories[0].pieces[3].angle_rad.reset(); }},
      Spoil{[](PlanFile& p) { p.trajectories[0].pieces[4].for_robot.reset(); }});
  PlanFile plan = sample_plan();
  spoil(plan);
  CHECK_THROWS_AS(to_geojson(plan), std::logic_error);
}

TEST_CASE("no locale changes the file", "[planfile][write]") {
  const std::string text = to_geojson(sample_plan());
  const std::locale before = std::locale::global(std::locale{std::locale::classic(), new CommaPoint});
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
    WARN("skipped: no locale de_DE.UTF-8 for C functions on this machine");
  CHECK(to_geojson(sample_plan()) == text);
  CHECK(plan_from_geojson(text, "plan.geojson") == sample_plan());
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
}

TEST_CASE("a trajectory of 100 000 samples is written and read whole", "[planfile][write]") {
  PlanFile plan = sample_plan();
  TrajectoryRecord& t = plan.trajectories.front();
  constexpr std::size_t kSamples = 100'000;
  t.line.resize(kSamples, {3.5, 46.5});
  t.t_s.resize(kSamples, 80);
  t.heading_rad.resize(kSamples, 0.5);
  t.curvature_per_m.resize(kSamples, 0.25);
  t.speed_mps.resize(kSamples, 1.5);
  t.tool.resize(kSamples, 1);
  CHECK(plan_from_geojson(to_geojson(plan), "plan.geojson") == plan);
}
