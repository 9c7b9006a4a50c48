// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <numbers>

#include "field_samples.hpp"
#include "selion/geometry/boolean.hpp"

using namespace selion;

namespace {

Ring rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

Obstacle obstacle(ObstacleKind kind, const Ring& ring) {
  return {"made", kind, polygon_of_metres({ring, {}})};
}

BlockOptions repairing() {
  BlockOptions options;
  options.repair = Repair::accept;
  return options;
}

Blocks repaired_blocks(const Field& field) {
  return blocks_of(field, LocalFrame::centred(centre(field)), repairing());
}

void check_clean(const Blocks& blocks) {
  for (const Block& block : blocks.blocks) {
    CHECK(fault(block.area) == "");
    CHECK(fault(block.free) == "");
    CHECK(area_m2(subtract({block.free}, {block.area})) < 1e-3);
  }
}

}  // namespace

TEST_CASE("a plain field becomes one block of the same corners, whichever way it winds", "[field][clean]") {
  const Field field = field_of_metres({{rectangle(0, 0, 200, 100), {}}});
  Field turned = field;
  std::reverse(turned.parts.front().shell.begin(), turned.parts.front().shell.end());
  const Blocks blocks = blocks_of(field);
  REQUIRE(blocks.blocks.size() == 1);
  CHECK(blocks.blocks.front().area.shell.size() == 4);
  CHECK(area_m2(blocks.blocks.front().area) == Approx(20000).margin(0.01));
  CHECK(blocks.blocks.front().free == blocks.blocks.front().area);
  CHECK(blocks.notes.empty());
  CHECK(blocks_of(turned) == blocks);
  check_clean(blocks);
}

TEST_CASE("repeated and almost repeated corners change nothing but a note", "[field][clean]") {
  const Ring ring = rectangle(0, 0, 200, 100);
  Ring repeated;
  for (const Point p : ring) repeated.insert(repeated.end(), {p, p, p + Point{1e-4, -1e-4}});
  const Blocks blocks = blocks_of(field_of_metres({{repeated, {}}}));
  CHECK(blocks.blocks == blocks_of(field_of_metres({{ring, {}}})).blocks);
  CHECK(any_mentions(blocks.notes, "8 corners"));
}

TEST_CASE("a ring that crosses itself is refused with the place, and --repair keeps both lobes",
          "[field][clean]") {
  const Field bow = field_of_metres({{{{0, 0}, {100, 100}, {100, 0}, {0, 60}}, {}}});
  const std::string message = error_of([&] { blocks_of(bow); });
  CHECK(mentions(message, "crosses itself"));
  CHECK(mentions(message, "feature 1"));
  CHECK(mentions(message, "--repair"));
  CHECK(mentions(message, "10.00052"));  // x = y = 37.5 m
  const Blocks both = repaired_blocks(bow);
  CHECK(both.blocks.size() == 2);
  check_clean(both);
}

TEST_CASE("a loop of the border over the field is refused too", "[field][clean]") {
  const Field curl = field_of_metres({{{{0, 0},
                                        {200, 0},
                                        {200, 100},
                                        {90, 100},
                                        {90, 40},
                                        {120, 40},
                                        {120, 70},
                                        {60, 70},
                                        {60, 100},
                                        {0, 100}},
                                       {}}});
  CHECK(mentions(error_of([&] { blocks_of(curl); }), "crosses itself"));
}

TEST_CASE("a bridge to a hole makes a hole", "[field][clean]") {
  const Field bridge = field_of_metres({{{{0, 0},
                                          {100, 0},
                                          {100, 100},
                                          {50, 100},
                                          {50, 60},
                                          {60, 60},
                                          {60, 40},
                                          {40, 40},
                                          {40, 60},
                                          {50, 60},
                                          {50, 100},
                                          {0, 100}},
                                         {}}});
  const Blocks blocks = blocks_of(bridge);
  REQUIRE(blocks.blocks.size() == 1);
  CHECK(blocks.blocks.front().area.holes.size() == 1);
  CHECK(area_m2(blocks.blocks.front().area) == Approx(10000 - 400).margin(0.01));
  CHECK(area_m2(blocks.blocks.front().free) < 10000 - 400 - 30);
  check_clean(blocks);
}

TEST_CASE("spikes without width are dropped with their length", "[field][clean]") {
  const Field spiky = field_of_metres({{{{0, 0},
                                         {100, 0},
                                         {100, 50},
                                         {150, 50},
                                         {100, 50},
                                         {100, 100},
                                         {0, 100},
                                         {0, 30},
                                         {40, 30},
                                         {70, 20},
                                         {40, 30},
                                         {0, 30}},
                                        {}}});
  const Blocks blocks = blocks_of(spiky);
  REQUIRE(blocks.blocks.size() == 1);
  CHECK(area_m2(blocks.blocks.front().area) == Approx(10000).margin(0.01));
  CHECK(any_mentions(blocks.notes, "50.00 m long"));
  check_clean(blocks);
}

TEST_CASE("a spike at the first corner is dropped as any other", "[field][clean]") {
  for (std::size_t turn = 0; turn < 6; ++turn) {
    Ring ring{{0, 0}, {100, 0}, {100, 100}, {160, 100}, {100, 100}, {0, 100}};
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(turn), ring.end());
    CAPTURE(turn);
    CHECK(blocks_area_m2(field_of_metres({{ring, {}}})) == Approx(10000).margin(0.01));
    CHECK(any_mentions(blocks_of(field_of_metres({{ring, {}}})).notes, "60.00 m long"));
  }
}

TEST_CASE("holes outside, overlapping or nested are refused unless the repair is below 1 cm",
          "[field][clean]") {
  const Ring shell = rectangle(0, 0, 100, 100);
  const auto with = [&](const std::vector<Ring>& holes) { return field_of_metres({{shell, holes}}); };
  CHECK(mentions(error_of([&] { blocks_of(with({rectangle(200, 0, 210, 10)})); }), "outside"));
  CHECK(mentions(error_of([&] { blocks_of(with({rectangle(90, 40, 110, 60)})); }), "outside"));
  CHECK(mentions(error_of([&] {
                   blocks_of(with({rectangle(20, 20, 50, 50), rectangle(40, 40, 60, 60)}));
                 }),
                 "shares 100 m2"));
  CHECK(mentions(error_of([&] {
                   blocks_of(with({rectangle(20, 20, 80, 80), rectangle(40, 40, 60, 60)}));
                 }),
                 "shares"));
  CHECK(mentions(error_of([&] { blocks_of(with({shell})); }), "zero area"));
  CHECK(blocks_area_m2(with({rectangle(90, 40, 100.006, 60)})) == Approx(10000 - 200).margin(0.1));
  const Blocks nested = repaired_blocks(with({rectangle(20, 20, 80, 80), rectangle(40, 40, 60, 60)}));
  CHECK(area_m2(nested.blocks.front().area) == Approx(10000 - 3600).margin(0.01));
}

TEST_CASE("a hole on the border becomes a notch of it", "[field][clean]") {
  const Blocks blocks =
      blocks_of(field_of_metres({{rectangle(0, 0, 100, 100), {rectangle(90, 40, 100, 60)}}}));
  REQUIRE(blocks.blocks.size() == 1);
  CHECK(blocks.blocks.front().area.holes.empty());
  CHECK(area_m2(blocks.blocks.front().area) == Approx(9800).margin(0.01));
  CHECK(any_mentions(blocks.notes, "notch"));
  check_clean(blocks);
}

TEST_CASE("a hole whose corner reaches out by less than 1 cm is cut there, and that is said",
          "[field][clean]") {
  const auto with = [](double corner_x_m) {
    const Ring hole{{80, 40}, {80, 60}, {corner_x_m, 50}};
    return blocks_of(field_of_metres({{rectangle(0, 0, 100, 100), {hole}}}));
  };
  CHECK(any_mentions(with(100.004).notes, "ring 2 is a hole that reaches out of its part by less than 1 cm"));
  CHECK(with(99.9).notes.empty());
  CHECK(with(100).notes.empty());
  CHECK(area_m2(with(100.004).blocks.front().area) == Approx(9800).margin(0.05));
  check_clean(with(100.004));
}

TEST_CASE("parts that share a border are joined, parts that overlap are refused, parts apart are blocks",
          "[field][clean]") {
  const Field touching = field_of_metres({{rectangle(0, 0, 50, 100), {}}, {rectangle(50, 0, 100, 100), {}}});
  CHECK(blocks_of(touching).blocks.size() == 1);
  CHECK(any_mentions(blocks_of(touching).notes, "joined"));
  const Field halves = field_of_metres({{rectangle(0, 0, 50, 100), {}}, {rectangle(50, 20, 100, 60), {}}});
  CHECK(blocks_of(halves).blocks.size() == 1);
  const Field overlapping =
      field_of_metres({{rectangle(0, 0, 60, 100), {}}, {rectangle(50, 0, 100, 100), {}}});
  CHECK(mentions(error_of([&] { blocks_of(overlapping); }), "part 2 shares 1000 m2"));
  CHECK(area_m2(repaired_blocks(overlapping).blocks.front().area) == Approx(10000).margin(0.01));
  const Blocks apart = blocks_of(field_of_metres(
      {{rectangle(0, 0, 20, 20), {}}, {rectangle(50, 0, 100, 100), {}}, {rectangle(30, 0, 30.5, 0.5), {}}}));
  REQUIRE(apart.blocks.size() == 2);
  CHECK(area_m2(apart.blocks[0].area) > area_m2(apart.blocks[1].area));
  CHECK(apart.blocks[1].number == 2);
  CHECK(any_mentions(apart.notes, "0.25 m2 is dropped"));
}

TEST_CASE("obstacles are taken off and keep their clearance, water its margin", "[field][clean]") {
  Field field = field_of_metres({{rectangle(0, 0, 200, 100), {rectangle(20, 20, 30, 30)}}});
  field.obstacles = {obstacle(ObstacleKind::obstacle, rectangle(60, 40, 70, 50)),
                     obstacle(ObstacleKind::water, rectangle(120, 40, 140, 60)),
                     obstacle(ObstacleKind::no_go, rectangle(-50, 80, 20, 150)),
                     obstacle(ObstacleKind::water, rectangle(0, -10, 200, 0))};
  const Blocks blocks = blocks_of(field);
  REQUIRE(blocks.blocks.size() == 1);
  const Block& block = blocks.blocks.front();
  CHECK(area_m2(block.area) == Approx(20000 - 100 - 100 - 400 - 400).margin(0.05));
  CHECK(block.area.holes.size() == 3);
  REQUIRE(block.obstacles.size() == 4);
  CHECK(block.obstacles[1].kind == ObstacleKind::water);
  CHECK(block.obstacles[1].name == "made");
  CHECK(area_m2(block.obstacles[1].area) == Approx(400).margin(0.05));
  const auto grown = [](double side_m, double by_m) {
    return side_m * side_m + 4 * side_m * by_m + std::numbers::pi * by_m * by_m;
  };
  const double corner = 20 * 20 + 2 * 20 * 0.5 + std::numbers::pi * 0.25 / 4;
  CHECK(area_m2(block.free) ==
        Approx(20000 - 2 * grown(10, 0.5) - grown(20, 3) - corner - 3 * 200).margin(0.2));
  check_clean(blocks);
}

TEST_CASE("what parts or loops of a ring enclose between them keeps its clearance as a hole does",
          "[field][clean]") {
  const Field frame = field_of_metres({{rectangle(0, 0, 100, 20), {}},
                                       {rectangle(0, 20, 20, 80), {}},
                                       {rectangle(80, 20, 100, 80), {}},
                                       {rectangle(0, 80, 100, 100), {}}});
  const Blocks joined = blocks_of(frame);
  REQUIRE(joined.blocks.size() == 1);
  CHECK(joined.blocks.front().area.holes.size() == 1);
  const double kept_m2 = 4 * 60 * 0.5 + std::numbers::pi * 0.25;
  CHECK(area_m2(joined.blocks.front().free) == Approx(10000 - 3600 - kept_m2).margin(0.1));
  // two parts that meet in points, or all but meet
  for (const double apart_m : {0.0, 0.002}) {
    const Field corners =
        field_of_metres({{{{0, 0}, {200, 0}, {200, 50}, {150, 50}, {50, 50}, {50, 150}, {0, 150}}, {}},
                         {{{50 + apart_m, 150},
                           {150, 150},
                           {150, 50 + apart_m},
                           {200, 50 + apart_m},
                           {200, 200},
                           {50 + apart_m, 200}},
                          {}}});
    const Blocks both = blocks_of(corners);
    double kept = 0;
    for (const Block& block : both.blocks) kept += area_m2(block.area) - area_m2(block.free);
    CHECK(kept == Approx(4 * 100 * 0.5).margin(1));
  }
  // a band that crosses its own tail: between them a triangle
  const Field knot = field_of_metres({{{{0, 0},
                                        {200, 0},
                                        {200, 100},
                                        {60, 100},
                                        {60, -40},
                                        {80, -40},
                                        {80, 80},
                                        {180, 80},
                                        {180, 20},
                                        {0, 20}},
                                       {}}});
  const Blocks knotted = repaired_blocks(knot);
  REQUIRE(knotted.blocks.size() == 1);
  REQUIRE(knotted.blocks.front().area.holes.size() == 1);
  CHECK(area_m2(knotted.blocks.front().area) - area_m2(knotted.blocks.front().free) ==
        Approx(320 * 0.5 + std::numbers::pi * 0.25).margin(0.1));
}

TEST_CASE("an obstacle that with its clearance cuts a part makes two blocks that share the area out",
          "[field][clean]") {
  const double hedge_m = GENERATE(4.0, 0.4);  // a thin one lets what is beside it reach over
  CAPTURE(hedge_m);
  Field field = field_of_metres({{rectangle(0, 0, 200, 100), {}}});
  field.obstacles = {obstacle(ObstacleKind::obstacle, rectangle(90, 0.3, 90 + hedge_m, 99.7))};
  field.gates = {{"west", polygon_of_metres({{{0, 50}}, {}}).shell.front(), {}},
                 {"east", polygon_of_metres({{{203, 50}}, {}}).shell.front(), 5.0}};
  const Blocks blocks = blocks_of(field);
  REQUIRE(blocks.blocks.size() == 2);
  CHECK(any_mentions(blocks.notes, "2 blocks"));
  CHECK(area_m2(blocks.blocks[0].area) + area_m2(blocks.blocks[1].area) ==
        Approx(20000 - hedge_m * 99.4).margin(0.5));
  CHECK(area_m2(blocks.blocks[1].area) == Approx(90 * 100).margin(3));
  CHECK(blocks.blocks[0].gates.size() == 1);
  CHECK(blocks.blocks[0].gates.front().name == "east");
  CHECK(blocks.blocks[1].gates.front().name == "west");
  check_clean(blocks);
}

TEST_CASE("gates are snapped to the border within 20 m and point inwards", "[field][clean]") {
  Field field = field_of_metres({{rectangle(0, 0, 200, 100), {}}});
  const auto at = [](double x, double y) { return polygon_of_metres({{{x, y}}, {}}).shell.front(); };
  field.gates = {{"south", at(50, -19), 4.0}, {"corner", at(-3, -3), {}}, {"far", at(100, -21), {}}};
  const Blocks blocks = blocks_of(field);
  REQUIRE(blocks.blocks.front().gates.size() == 2);
  const BlockGate& south = blocks.blocks.front().gates[0];
  CHECK(south.width_m == 4.0);
  CHECK(south.inward_rad == Approx(std::numbers::pi / 2).margin(1e-3));
  CHECK(blocks.blocks.front().gates[1].inward_rad == Approx(std::numbers::pi / 4).margin(1e-3));
  CHECK(any_mentions(blocks.notes, "'far'"));
  CHECK(contains(blocks.blocks.front().area, south.at + 0.01 * unit(south.inward_rad)));
}

TEST_CASE("no area and places too far apart are refused", "[field][clean]") {
  CHECK(mentions(error_of([] {
                   blocks_of(field_of_metres({{{{0, 0}, {100, 0}, {50, 0.001}}, {}}}));
                 }),
                 "zero area"));
  Field far = field_of_metres({{rectangle(0, 0, 100, 100), {}}});
  far.parts.front().shell[2].lon_deg += 3;
  CHECK(mentions(error_of([&] { blocks_of(far); }), "100 km"));
  Field filled = field_of_metres({{rectangle(0, 0, 100, 100), {}}});
  filled.obstacles = {obstacle(ObstacleKind::water, rectangle(1, 1, 99, 99))};
  CHECK(mentions(error_of([&] { blocks_of(filled); }), "no area left"));
}
