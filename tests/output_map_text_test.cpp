// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <string>

#include "output_plan_samples.hpp"
#include "selion/output/report.hpp"

using namespace selion;

namespace {

std::string row(const MapText& text, const std::string& label) {
  for (const auto& [name, value] : text.data) {
    if (name == label) return value;
  }
  return "no such row";
}

Job imperial() {
  Job job;
  job.output.units = "imperial";
  return job;
}

Plan one_block() {
  Plan plan = reported_plan();
  plan.blocks.resize(1);
  return plan;
}

}  // namespace

TEST_CASE("the map's title is the field and the operation", "[output][map_text]") {
  Job job;
  job.operation = Operation::mowing;
  CHECK(map_text(reported_plan(), job).title == "Pr\u00E8s du bois - mowing");
  Plan nameless = reported_plan();
  nameless.file.fields.front().name.clear();
  CHECK(map_text(nameless, job).title == "Field - mowing");
}

TEST_CASE("the data box of one block, metric", "[output][map_text]") {
  const MapText text = map_text(one_block(), Job{});
  CHECK(row(text, "Field area") == "8.00 ha");
  CHECK(row(text, "Blocks") == "no such row");
  CHECK(row(text, "Covered") == "7.96 ha (99.5 %)");
  CHECK(row(text, "Not covered") == "0.04 ha in 2 places");
  CHECK(row(text, "Worked twice") == "0.10 ha (1.2 %)");
  CHECK(row(text, "Working width") == "3.00 m");
  CHECK(row(text, "Heading A to B, true") == "012.5\u00B0");
  CHECK(row(text, "Swaths") == "60, 65 pieces");
  CHECK(row(text, "Longest swath") == "378.1 m (no. 12a)");
  CHECK(row(text, "Headland") == "3 passes, 9.0 m");
  CHECK(row(text, "Working distance") == "26.0 km");
  CHECK(row(text, "Driving distance") == "28.5 km");
  CHECK(row(text, "of it in reverse") == "40 m");
  CHECK(row(text, "Turns") == "59");
  CHECK(row(text, "Time") == "5 h 22 min");  // 19 300 s
  CHECK(row(text, "of it working") == "4 h 43 min");
}

TEST_CASE("the data box of one block, imperial", "[output][map_text]") {
  const MapText text = map_text(one_block(), imperial());
  CHECK(row(text, "Field area") == "19.77 ac");  // 80 000 / 4046.8564224
  CHECK(row(text, "Working width") == "9.84 ft");
  CHECK(row(text, "Longest swath") == "1240.6 ft (no. 12a)");
  CHECK(row(text, "Driving distance") == "17.7 mi");  // 28 500 / 1609.344
  CHECK(row(text, "of it in reverse") == "131 ft");
}

TEST_CASE("several blocks stand side by side where they differ", "[output][map_text]") {
  const MapText text = map_text(reported_plan(), Job{});
  CHECK(row(text, "Blocks") == "3, 1 not planned");
  CHECK(row(text, "Heading A to B, true") == "1: 012.5\u00B0; 2: 090.0\u00B0");
  CHECK(row(text, "Headland") == "1: 3 passes, 9.0 m; 2: 1 pass, 3.0 m");
  CHECK(row(text, "Longest swath") == "378.1 m (no. 12a, block 1)");
  Plan same = reported_plan();
  same.blocks[1].bearing_deg = 12.5;
  CHECK(row(map_text(same, Job{}), "Heading A to B, true") == "012.5\u00B0");
}

TEST_CASE("the headland's area is its share of the field", "[output][map_text]") {
  Plan plan = one_block();
  const auto square = [](double lon, double lat, double side) {
    return LonLatLine{{lon, lat}, {lon + side, lat}, {lon + side, lat + side}, {lon, lat + side}};
  };
  plan.file.fields = {{{{square(3.4, 46.33, 0.004), {}}}, "F", 80'000, {}}};
  plan.file.headlands = {{1, {{square(3.4, 46.33, 0.004), {square(3.401, 46.331, 0.002)}}}, 9, 3}};
  CHECK(row(map_text(plan, Job{}), "Headland area") == "6.00 ha (75.0 %)");
  plan.file.headlands.clear();
  CHECK(row(map_text(plan, Job{}), "Headland area") == "0.00 ha (0.0 %)");
}

TEST_CASE("small areas and short times keep a figure", "[output][map_text]") {
  Plan plan = one_block();
  plan.blocks[0].uncovered.resize(1);
  plan.blocks[0].covered_m2 = plan.blocks[0].area_m2 - 7.4;
  plan.blocks[0].work_s = 41.2;
  plan.blocks[0].turn_s = 18.2;
  plan.blocks[0].transfer_s = 0;
  const MapText text = map_text(plan, Job{});
  CHECK(row(text, "Not covered") == "7 m\u00B2 in 1 place");
  CHECK(row(text, "of it working") == "41 s");
  CHECK(row(text, "Time") == "59 s");
  CHECK(row(map_text(plan, imperial()), "Not covered") == "80 ft\u00B2 in 1 place");
}

TEST_CASE("assumptions and warnings come with the map", "[output][map_text]") {
  const MapText text = map_text(reported_plan(), Job{});
  CHECK(text.assumptions == reported_plan().assumptions);
  CHECK(text.warnings == reported_plan().file.warnings);
  CHECK_FALSE(text.date.has_value());
}

TEST_CASE("the map says notes, those of planning before those of reading", "[output][map_text]") {
  Plan plan = reported_plan();
  plan.notes = {"1 spike removed", "Block 1: it starts 15 degrees askew", "2 corners dropped"};
  CHECK(map_text(plan, Job{}).notes == std::vector<std::string>{"Block 1: it starts 15 degrees askew",
                                                                "1 spike removed", "2 corners dropped"});
}
