// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <cmath>

#include "output/drawing.hpp"
#include "output/font.hpp"
#include "output/label_placer.hpp"
#include "output/map_style.hpp"
#include "output/map_view.hpp"

using namespace selion;

TEST_CASE("a placer gives out no room twice and none outside", "[output][drawing]") {
  LabelPlacer placer{{0, 0, 100, 60}};
  placer.take({40, 20, 60, 40});
  std::vector<PageBox> placed{{40, 20, 60, 40}};
  for (int i = 0; i < 40; ++i)
    if (const auto box = placer.place(boxes_near({50, 30}, 12, 4, 1, 80))) {
      CHECK(holds({0, 0, 100, 60}, *box));
      for (const PageBox& other : placed) CHECK_FALSE(overlap(*box, other));
      placed.push_back(*box);
    }
  CHECK(placed.size() > 15);
  CHECK_FALSE(placer.place({PageBox{45, 25, 50, 30}}).has_value());
}

TEST_CASE("wrapped text keeps its words and its width", "[output][drawing]") {
  const Font font;
  const TextStyle style{8, Weight::regular};
  const std::string text = "a plan is not a survey " + std::string(80, 'W') + " end";
  std::string joined;
  for (const std::string& line : font.wrapped(text, style, 40)) {
    CHECK(font.width_mm(line, style) <= 40);
    joined += line;
  }
  joined.erase(std::remove(joined.begin(), joined.end(), ' '), joined.end());
  std::string bare = text;
  bare.erase(std::remove(bare.begin(), bare.end(), ' '), bare.end());
  CHECK(joined == bare);
  CHECK(font.width_mm(font.shortened(text, style, 30), style) <= 30);
  CHECK(font.shortened("short", style, 30) == "short");
}

TEST_CASE("a line takes every word that still fits", "[output][drawing]") {
  const Font font;
  const TextStyle style{8, Weight::bold};
  const std::string text =
      GENERATE(as<std::string>{}, "AV To. Wa fi ffl  Y, L' Ta V. Wo Te. fj LT r. \u00C5k\u00E9r",
               "V. \u0627\u0644\u062D\u0642\u0644 \u0627\u0644\u0643\u0628\u064A\u0631 Wo Te. fj LT r.");
  const double width_mm = GENERATE(range(12.0, 40.0, 0.37));
  const std::vector<std::string> lines = font.wrapped(text, style, width_mm);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CHECK(font.width_mm(lines[i], style) <= width_mm);
    if (i + 1 < lines.size())
      CHECK(font.width_mm(lines[i] + ' ' + lines[i + 1].substr(0, lines[i + 1].find(' ')), style) > width_mm);
  }
}

TEST_CASE("thinning moves no point by more than a twentieth of a millimetre", "[output][drawing]") {
  PageLine arc;
  for (int i = 0; i <= 2000; ++i) arc.push_back({20 * std::cos(i * 0.001), 20 * std::sin(i * 0.001)});
  const PageLine thin = thinned(arc);
  CHECK(thin.size() < 40);
  CHECK(thin.front() == arc.front());
  CHECK(thin.back() == arc.back());
  for (std::size_t i = 1; i < thin.size(); ++i) {
    const PagePoint middle{(thin[i - 1].x_mm + thin[i].x_mm) / 2, (thin[i - 1].y_mm + thin[i].y_mm) / 2};
    CHECK(std::abs(distance_mm(middle, {0, 0}) - 20) < 0.051);
  }
}

TEST_CASE("text that is no valid UTF-8 becomes text that XML takes", "[output][drawing]") {
  CHECK(printable("a\tb\x01"
                  "c") == "a b c");
  CHECK(printable("caf\xC3\xA9") == "caf\xC3\xA9");
  CHECK(printable("a\xE2\x80\xAE"
                  "b\xE2\x81\xA6") == "a b ");
  CHECK(printable("\xFF").size() == 3);  // U+FFFD
}

TEST_CASE("hatching stays inside the area and out of its hole", "[output][drawing]") {
  const std::vector<PageLine> rings{{{0, 0}, {30, 0}, {30, 20}, {0, 20}},
                                    {{10, 5}, {20, 5}, {20, 15}, {10, 15}}};
  const std::vector<PageLine> lines = hatching(rings, 45, 1.4);
  CHECK(lines.size() > 30);
  for (const PageLine& line : lines) {
    const PagePoint middle{(line[0].x_mm + line[1].x_mm) / 2, (line[0].y_mm + line[1].y_mm) / 2};
    CHECK(holds(PageBox{0, 0, 30, 20}, middle));
    CHECK_FALSE(holds(PageBox{10.01, 5.01, 19.99, 14.99}, middle));
  }
}
