// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <fstream>
#include <iterator>
#include <random>

#include "files.hpp"
#include "planfile_samples.hpp"
#include "selion/planfile/planfile.hpp"

using namespace selion;

namespace {

PlanFile read(const std::string& text) { return plan_from_geojson(text, "plan.geojson"); }

struct Chance {
  std::mt19937_64 engine;

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11U) * 0x1p-53;
  }
  int whole(int low, int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1));
  }
  LonLat place() { return {between(-180, 180), between(-90, 90)}; }

  LonLatLine line(int least) {
    LonLatLine out(static_cast<std::size_t>(whole(least, least + 6)));
    for (LonLat& at : out) at = place();
    return out;
  }

  std::vector<LonLatArea> parts() {
    std::vector<LonLatArea> out(static_cast<std::size_t>(whole(1, 3)));
    for (LonLatArea& part : out) {
      part.shell = line(3);
      for (int i = whole(0, 2); i > 0; --i) part.holes.push_back(line(3));
    }
    return out;
  }

  /// Any bytes but those that are not UTF-8.
  std::string text() {
    std::string out;
    for (int i = whole(0, 12); i > 0; --i)
      out += whole(0, 9) == 0 ? "\xE2\x82\xAC" : std::string(1, static_cast<char>(whole(0, 127)));
    return out;
  }

  std::vector<double> numbers(std::size_t count, double size) {
    std::vector<double> out(count);
    for (double& value : out) value = between(-size, size);
    return out;
  }

  PieceRecord piece() {
    PieceRecord p{.kind = whole(0, 1) == 0 ? "pivot" : "wait", .ref = text()};
    p.x_m = between(-1e7, 1e7);
    p.y_m = between(-1e7, 1e7);
    p.heading_rad = between(-100, 100);
    p.curvature_per_m = between(-2, 2);
    p.sharpness_per_m2 = between(-50, 50);
    p.length_m = between(0, 5000);
    p.offset_m = between(-20, 20);
    p.gear = whole(0, 1) == 0 ? -1 : 1;
    p.tool = whole(0, 1);
    p.angle_rad = between(-3, 3);
    p.duration_s = between(0, 1e4);
    if (whole(0, 1) == 0) {
      p.for_robot = whole(1, 9);
      p.until_station_m = between(0, 1e5);
    }
    return p;
  }

  TrajectoryRecord trajectory() {
    TrajectoryRecord t{.block = whole(1, 9),
                       .robot = whole(1, 9),
                       .working_width_m = between(0, 50),
                       .length_m = between(0, 1e6)};
    t.duration_s = between(0, 1e6);
    for (int i = whole(1, 5); i > 0; --i) t.pieces.push_back(piece());
    t.line = line(2);
    t.t_s = numbers(t.line.size(), 1e6);
    t.heading_rad = numbers(t.line.size(), 1e3);
    t.curvature_per_m = numbers(t.line.size(), 2);
    t.speed_mps = numbers(t.line.size(), 20);
    for (std::size_t i = 0; i < t.line.size(); ++i) t.tool.push_back(whole(0, 1));
    return t;
  }

  PlanFile plan() {
    PlanFile p = sample_plan();
    p.version = text();
    p.proj = "+proj=tmerc +lat_0=" + std::to_string(whole(-80, 80)) + " +ellps=WGS84";
    p.origin = place();
    p.summary = {{"a", between(-1e9, 1e9)}, {"Z_9", between(-1, 1)}};
    p.warnings = {text(), text()};
    p.fields.push_back({parts(), text(), between(0, 1e9), {text()}});
    p.obstacles.push_back({whole(1, 99), parts().front(), text(), "no_go"});
    p.gates.push_back({whole(1, 99), place(), text(), between(0, 20)});
    p.cells.push_back({whole(1, 99), text(), parts(), between(0, 360)});
    p.ab_lines.push_back({whole(1, 99), place(), place(), between(0, 360)});
    p.headlands.push_back({whole(1, 99), parts(), between(0, 100), whole(0, 9)});
    p.headland_passes.push_back({whole(1, 99), text(), whole(1, 9), line(2), between(0, 50)});
    p.swaths.push_back(
        {whole(1, 99), text(), text(), line(2), between(0, 50), between(0, 5000), whole(0, 999)});
    p.trajectories.push_back(trajectory());
    return p;
  }
};

}  // namespace

TEST_CASE("a plan of rounded numbers comes back equal", "[planfile][round_trip]") {
  CHECK(read(to_geojson(sample_plan())) == sample_plan());
}

TEST_CASE("any plan is written the same after it was read", "[planfile][round_trip]") {
  const auto seed = GENERATE(range(1U, 201U));
  CAPTURE(seed);
  const std::string text = to_geojson(Chance{std::mt19937_64{seed}}.plan());

  const PlanFile once = read(text);

  CHECK(to_geojson(once) == text);
  CHECK(read(to_geojson(once)) == once);
}

TEST_CASE("a ring so thin that rounding turns it over is written the same again", "[planfile][round_trip]") {
  PlanFile plan = sample_plan();
  plan.fields.front().parts = {{{{3.0, 46.0}, {3.001, 46.0000000004}, {3.002, 46.0000000007}}, {}}};
  const std::string text = to_geojson(plan);
  CHECK(to_geojson(read(text)) == text);
}

TEST_CASE("a plan of no features is a plan", "[planfile][round_trip]") {
  PlanFile plan;
  plan.id = "0123456789abcdef";
  plan.job_json = "{}";
  CHECK(read(to_geojson(plan)) == plan);
}

TEST_CASE("the job keeps its keys' order and its numbers' digits", "[planfile][round_trip]") {
  PlanFile plan = sample_plan();
  plan.job_json =
      R"({"z":1.50,"a":{"selion":"{\"job\":1}","job":[1e5,-0.0,12345678901234567890]},"m":"é \\ \"}"})";
  CHECK(read(to_geojson(plan)).job_json == plan.job_json);
}

TEST_CASE("a job on many lines is made compact", "[planfile][round_trip]") {
  PlanFile plan = sample_plan();
  plan.job_json = "{ \"a b\" : [ 1 ,\n\t2 ],\n \"c\":\"d  e\" }\n";
  CHECK(read(to_geojson(plan)).job_json == R"({"a b":[1,2],"c":"d  e"})");
}

TEST_CASE("features in another order and with members that nobody asks for are read",
          "[planfile][round_trip]") {
  std::string text = to_geojson(sample_plan());
  const std::size_t begin = text.find("    {\"type\": \"Feature\"");
  const std::size_t end = text.find('\n', begin) + 1;
  const std::string field = text.substr(begin, end - begin);
  text.erase(begin, field.size());
  text = replaced(text, "\"features\": [\n", "\"name\": \"plan\", \"features\": [\n");
  const std::size_t last = text.rfind("\n  ]");
  text.insert(last, ",\n" + replaced(field.substr(0, field.size() - 2), "\"type\": \"Feature\"",
                                     "\"id\": 7, \"type\": \"Feature\""));
  CHECK(read(text) == sample_plan());
}

TEST_CASE("the example of docs/plan.md is a plan file, byte for byte", "[planfile][round_trip]") {
  std::ifstream page{project_dir() / "docs/plan.md"};
  REQUIRE(page);
  const std::string text{std::istreambuf_iterator<char>{page}, {}};
  const std::string fence = "```json\n";
  const std::size_t begin = text.find(fence) + fence.size();
  const std::string example = text.substr(begin, text.find("```", begin) - begin);
  CHECK(to_geojson(read(example)) == example);
}
