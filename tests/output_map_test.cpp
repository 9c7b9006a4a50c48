// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <pugixml.hpp>

#include "output/font.hpp"
#include "output/map_style.hpp"
#include "output/map_view.hpp"
#include "output_map_samples.hpp"
#include "selion/core/error.hpp"

using namespace selion;

namespace {

const MapOptions kA4{Units::metric, Paper::a4};

PlanFile two_blocks() {
  Polygon angled{{{-150, -120}, {150, -120}, {150, 10}, {20, 10}, {20, 150}, {-150, 150}}, {}};
  angled.holes.push_back({{-80, -40}, {-80, 10}, {-30, 10}, {-30, -40}});
  return sample_plan({{angled, rectangle({180, -100}, 90, 60)}, 3, 9, 12.5});
}

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(svg.data(), svg.size(), pugi::parse_full);
  REQUIRE(result.status == pugi::status_ok);
  return document;
}

std::vector<pugi::xml_node> texts_in(const pugi::xml_document& svg, const std::string& where) {
  std::vector<pugi::xml_node> nodes;
  for (const pugi::xpath_node& found : svg.select_nodes((where + "//text").c_str()))
    nodes.push_back(found.node());
  return nodes;
}

/// All text below `where`, a space between lines.
std::string words_in(const pugi::xml_document& svg, const std::string& where) {
  std::string words;
  for (const pugi::xml_node& node : texts_in(svg, where)) words += std::string{node.text().get()} + ' ';
  return words;
}

/// The ink's box of a level text, from its letters' width and the height of its capitals.
PageBox box_of(const Font& font, const pugi::xml_node& node) {
  const TextStyle style{
      node.attribute("font-size").as_double() * 72 / 25.4,
      std::string{node.attribute("font-weight").value()} == "bold" ? Weight::bold : Weight::regular};
  const double width = font.width_mm(node.text().get(), style);
  const std::string anchor = node.attribute("text-anchor").value();
  const double left = node.attribute("x").as_double() - (anchor == "end"      ? width
                                                         : anchor == "middle" ? width / 2
                                                                              : 0);
  const double base = node.attribute("y").as_double();
  return {left, base - cap_height_mm(style), left + width, base};
}

std::string in_group(const std::string& name) { return "//*[@class='" + name + "']"; }

PageBox frame_of(const pugi::xml_document& svg) {
  // The clip of the map's group is the frame.
  const pugi::xml_node rect = svg.select_node("//*[local-name()='clipPath']/*").node();
  const double x = rect.attribute("x").as_double();
  const double y = rect.attribute("y").as_double();
  return {x, y, x + rect.attribute("width").as_double(), y + rect.attribute("height").as_double()};
}

void check_texts(const std::string& svg_bytes) {
  const pugi::xml_document svg = parsed(svg_bytes);
  const Font font;
  const pugi::xml_node root = svg.child("svg");
  std::stringstream view{root.attribute("viewBox").value()};
  PageBox page;
  view >> page.left_mm >> page.top_mm >> page.right_mm >> page.bottom_mm;
  std::vector<PageBox> boxes;
  for (const pugi::xml_node& node : texts_in(svg, "")) {
    CAPTURE(node.text().get());
    CHECK(node.attribute("font-size").as_double() * 72 / 25.4 >= 6.99);
    if (!node.attribute("transform").empty()) continue;
    const PageBox box = box_of(font, node);
    CHECK(holds(page, box));
    CHECK(std::none_of(boxes.begin(), boxes.end(),
                       [&](const PageBox& other) { return overlap(grown(other, -0.05), box); }));
    boxes.push_back(box);
  }
}

std::string pdf_words(const std::string& pdf) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::string file = (folder / "selion_map_test.pdf").string();
  std::ofstream{file, std::ios::binary} << pdf;
  FILE* pipe = popen(("pdftotext -layout '" + file + "' - 2>/dev/null").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string words;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) words += static_cast<char>(c);
  pclose(pipe);
  std::filesystem::remove(file);
  return words;
}

}  // namespace

TEST_CASE("the same plan gives the same bytes", "[output][map]") {
  const PlanFile plan = two_blocks();
  const MapFiles once = map_files(plan, sample_text(), kA4);
  const MapFiles again = map_files(plan, sample_text(), kA4);
  CHECK(once.svg == again.svg);
  CHECK(once.pdf == again.pdf);
  CHECK(once.pdf.find("CreationDate") == std::string::npos);
}

TEST_CASE("a PDF is one page whose text can be found", "[output][map]") {
  const std::string pdf = map_files(two_blocks(), sample_text(), kA4).pdf;
  REQUIRE(pdf.substr(0, 5) == "%PDF-");
  if (std::system("command -v pdftotext >/dev/null 2>&1") != 0) {
    WARN("skipped: pdftotext is not installed");
    return;
  }
  const std::string words = pdf_words(pdf);
  for (const char* expected : {"Grand champ - seeding", "3f9c2a7be01d", "AB 012.5\u00B0", "Block 2",
                               "5.09 ha", "not a survey", "Scale 1 :"})
    CHECK(words.find(expected) != std::string::npos);
  CHECK(std::count(words.begin(), words.end(), '\f') == 1);
}

TEST_CASE("an SVG is well-formed and has its title as text", "[output][map]") {
  MapText text = sample_text();
  text.title = "Fish & Chips <north> \"field\"";
  PlanFile plan = two_blocks();
  plan.gates.push_back({1, plan.fields[0].parts[0].shell[0], "A&B <gate>\x01\xFF", 6.0});
  const pugi::xml_document svg = parsed(map_files(plan, text, kA4).svg);
  CHECK(words_in(svg, in_group("head")).find(text.title) != std::string::npos);
  CHECK(words_in(svg, in_group("place-names")).find("A&B <gate>") != std::string::npos);
  CHECK(words_in(svg, in_group("place-names")).find("(6.0 m)") != std::string::npos);
}

TEST_CASE("no text overlaps another or leaves the page", "[output][map]") {
  MapText text = sample_text();
  SECTION("blocks, a hole, warnings") {
    text.warnings = {"Driving between the blocks is not planned.",
                     std::string(300, 'w') + ' ' + std::string(90, 'm')};
    check_texts(map_files(two_blocks(), text, kA4).svg);
    check_texts(map_files(two_blocks(), text, {Units::imperial, Paper::letter}).svg);
  }
  SECTION("a long strip") {
    check_texts(map_files(sample_plan({{rectangle({-364, -14}, 729, 29)}, 3, 6, 90}), text, kA4).svg);
  }
  SECTION("a field with hundreds of swaths") {
    check_texts(map_files(sample_plan({{rectangle({-1125, -1280}, 2250, 2560)}, 3, 9, 3}), text, kA4).svg);
    check_texts(map_files(sample_plan({{rectangle({-1125, -1280}, 2250, 2560)}, 3, 9, 3}), text,
                          {Units::metric, Paper::a3})
                    .svg);
  }
  SECTION("more text than a page holds") {
    for (int i = 0; i < 80; ++i)
      text.assumptions.push_back("Assumption " + std::to_string(i) + " of eighty, long enough to wrap once.");
    for (int i = 0; i < 40; ++i)
      text.warnings.push_back("Warning " + std::to_string(i) + ": part of the field is too small.");
    for (int i = 0; i < 60; ++i)
      text.notes.push_back("Note " + std::to_string(i) + " of sixty, " +
                           std::string(static_cast<std::size_t>(i), 'n') + " and so on.");
    for (int i = 0; i < 90; ++i) text.data.emplace_back("Figure " + std::to_string(i), "1.00 ha");
    const std::string svg = map_files(two_blocks(), text, kA4).svg;
    check_texts(svg);
    CHECK(words_in(parsed(svg), in_group("head")).find("more warnings") != std::string::npos);
  }
  SECTION("nothing but a frame") {
    PlanFile empty;
    empty.proj = two_blocks().proj;
    empty.origin = {3.43, 46.33};
    check_texts(map_files(empty, {}, kA4).svg);
  }
}

TEST_CASE("notes stand on the map, long ones cut, many counted", "[output][map]") {
  MapText text = sample_text();
  text.notes = {"Block 1: It is planned with 1 headland pass instead of the 2 that turns need."};
  const auto panel = [&] {
    return words_in(parsed(map_files(two_blocks(), text, kA4).svg), in_group("panel"));
  };
  CHECK(panel().find("Notes") != std::string::npos);
  CHECK(panel().find("planned with 1 headland") != std::string::npos);
  CHECK(panel().find("more: see") == std::string::npos);
  for (int i = 0; i < 30; ++i)
    text.notes.push_back(std::string(400, static_cast<char>('a' + i % 26)) + " end");
  CHECK(panel().find("more: see") != std::string::npos);
  CHECK(panel().find("\u2026") != std::string::npos);
  CHECK(panel().find("planned with 1 headland") != std::string::npos);
}

TEST_CASE("the first and last swath are numbered, and every number lies inside the frame", "[output][map]") {
  const PlanFile plan = sample_plan({{rectangle({-400, -300}, 800, 600)}, 3, 9, 30});
  const pugi::xml_document svg = parsed(map_files(plan, sample_text(), kA4).svg);
  const Font font;
  std::set<std::string> numbers;
  for (const pugi::xml_node& node : texts_in(svg, in_group("swath-numbers"))) {
    CHECK(holds(frame_of(svg), box_of(font, node)));
    numbers.insert(node.text().get());
  }
  CHECK(numbers.contains(plan.swaths.front().id));
  CHECK(numbers.contains(plan.swaths.back().id));
  CHECK(numbers.size() > 10);
}

TEST_CASE("both pieces of a split swath carry their letters", "[output][map]") {
  const std::string numbers =
      words_in(parsed(map_files(two_blocks(), sample_text(), kA4).svg), in_group("swath-numbers"));
  const std::size_t split = numbers.find("a ");
  REQUIRE(split != std::string::npos);
  const std::string number =
      numbers.substr(numbers.rfind(' ', split) + 1, split - numbers.rfind(' ', split) - 1);
  CHECK(numbers.find(number + "b ") != std::string::npos);
}

TEST_CASE("the legend lists what is drawn and nothing else", "[output][map]") {
  PlanFile plan = two_blocks();
  const auto check = [&] {
    const pugi::xml_document svg = parsed(map_files(plan, sample_text(), kA4).svg);
    const std::string panel = words_in(svg, in_group("panel"));
    for (const Mark mark :
         {Mark::boundary, Mark::headland,  Mark::headland_pass, Mark::swath,      Mark::swath_number,
          Mark::order,    Mark::direction, Mark::undriven,      Mark::cell,       Mark::turn,
          Mark::transfer, Mark::reverse,   Mark::pivot,         Mark::start,      Mark::end,
          Mark::gate,     Mark::ab,        Mark::hole,          Mark::small_hole, Mark::water,
          Mark::no_go}) {
      const MarkStyle& style = style_of(mark);
      CAPTURE(style.layer);
      const std::string words{style.legend.substr(0, 24)};
      CHECK(svg.select_node(in_group(std::string{style.layer}).c_str()).node().empty() ==
            (panel.find(words) == std::string::npos));
    }
  };
  SECTION("a plan with much in it") {
    const LonLat at = plan.swaths[40].line[0];
    plan.gates.push_back({1, plan.fields[0].parts[0].shell[0], "", {}});
    plan.obstacles.push_back({1,
                              {{at, {at.lon_deg + 1e-5, at.lat_deg}, {at.lon_deg, at.lat_deg + 1e-5}}, {}},
                              "Pylon",
                              "obstacle"});
    plan.obstacles.push_back(
        {1, {{at, {at.lon_deg + 4e-4, at.lat_deg}, {at.lon_deg, at.lat_deg + 4e-4}}, {}}, "Pond", "water"});
    plan.trajectories[0].pieces[1].gear = -1;
    plan.trajectories[0].pieces[3].kind = "pivot";
    plan.swaths[9].order = 0;
    check();
  }
  SECTION("a plan that drives nothing") {
    plan.trajectories.clear();
    plan.swaths.clear();
    plan.ab_lines.clear();
    check();
  }
  SECTION("an obstacle outside the map's paper is not in its legend") {
    plan.fields[0].parts.pop_back();
    plan.obstacles.push_back({1, {{{5, 46}, {5.1, 46}, {5, 46.1}}, {}}, "far away", "no_go"});
    check();
  }
}

TEST_CASE("the north arrow knows the convergence of a state grid", "[output][map]") {
  PlanFile plan;
  plan.proj =
      "+proj=lcc +lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80 +units=m "
      "+no_defs +type=crs";
  plan.origin = {-3.5, 48};
  // Lambert-93 (Snyder 1987, p. 107): convergence n (lon - lon_0), n = 0.7256077650, here east is positive.
  const PlanPlane plane{plan.proj};
  CHECK(plane.convergence_deg(plane.to_local(plan.origin)) == Approx(0.7256077650 * -6.5).margin(1e-3));
  const std::string words = words_in(parsed(map_files(plan, {}, kA4).svg), in_group("scale"));
  CHECK(words.find("4.72\u00B0 west") != std::string::npos);
}

TEST_CASE("a frame that PROJ does not know is an error of the plan file", "[output][map]") {
  PlanFile plan;
  plan.proj = "+proj=nonsense";
  CHECK_THROWS_AS(map_files(plan, {}, kA4), InputError);
}
