// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <filesystem>
#include <numbers>
#include <sstream>

#include "files.hpp"
#include "selion/field/block.hpp"
#include "selion/field/read.hpp"
#include "selion/layout/direction.hpp"

using namespace selion;

namespace {

Polygon paper_field(int number) {
  std::istringstream nothing;
  const auto file = data_dir() / "fields" / ("f" + std::to_string(number) + ".geojson");
  const Field field = read_fields(file, {}, nothing).at(0);
  return blocks_of(field, LocalFrame::centred(centre(field)), {}).blocks.at(0).area;
}

}  // namespace

TEST_CASE("the paper's rule gives the paper's rotations", "[layout]") {
  // published angles: the design's table of Cariou et al. 2020, fields F1 ... F6
  const double rotations[] = {77, 7, 169, 105, 83, 130};
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i + 1);
    const auto found = p3_direction(paper_field(i + 1));
    REQUIRE(found.has_value());
    CHECK(found->rotation_deg == rotations[i]);
  }
}

TEST_CASE("the best edge needs no more pieces than any whole degree", "[layout]") {
  const int number = GENERATE(1, 2, 3, 4, 5, 6);
  CAPTURE(number);
  const Polygon field = paper_field(number);
  const double best = expected_pieces(field, best_edge_direction(field), 4);
  for (int degree = 0; degree < 180; ++degree)
    CHECK(best <= expected_pieces(field, DrivingDirection::bearing_deg(degree), 4) + 1e-9);
}

TEST_CASE("a bearing of 0 drives north and south", "[layout]") {
  CHECK(DrivingDirection::bearing_deg(0).radians() == Approx(std::numbers::pi / 2));
  CHECK(DrivingDirection::bearing_deg(0) == DrivingDirection::bearing_deg(180));
  CHECK(DrivingDirection::bearing_deg(90).bearing_deg() == Approx(90));
}
