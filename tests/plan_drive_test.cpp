// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <numbers>

#include "plan/drive.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

Machine with_tool(double raise_s, double lower_s, double run_in_m) {
  Machine m;
  m.tool_raise_s = raise_s;
  m.tool_lower_s = lower_s;
  m.run_in_m = run_in_m;
  return m;
}

/// Swath 1 to the east, a turn, the run-in where there is one, swath 2 back.
Route two_swaths(const Machine& m) {
  const Path first{{line({0, 0}, {50, 0})}};
  const Pose start{{50, 6}, std::numbers::pi};
  const Pose before{start.at + Point{m.run_in_m, 0}, std::numbers::pi};
  Path way = connections(end_pose(first), before, limits_at(m, m.turn_speed_mps)).front();
  if (m.run_in_m > 0) way.push_back({line(before.at, start.at)});
  return {{{PieceKind::swath, "1", first},
           {PieceKind::turn, "", way},
           {PieceKind::swath, "2", {{line(start.at, {0, 6})}}}},
          {},
          {},
          {}};
}

/// Swath 1 to the east, back beside it in reverse, swath 2 to the east.
Route with_reverse() {
  const Path first{{line({0, 0}, {50, 0})}};
  const Curve back{{50, 0}, std::numbers::pi, 0, 0, 50};
  return {{{PieceKind::swath, "1", first},
           {PieceKind::transfer, "", {{back, Gear::reverse}}},
           {PieceKind::swath, "2", first}},
          {},
          {},
          {}};
}

std::vector<double> waits_of(const Drive& drive) {
  std::vector<double> waits;
  for (const DrivePiece& piece : drive.pieces)
    if (piece.leg.wait_s > 0) waits.push_back(piece.leg.wait_s);
  return waits;
}

/// The first sample at the start of a leg of this piece.
const Sample& start_of(const Drive& drive, const std::string& ref) {
  return *std::find_if(drive.samples.begin(), drive.samples.end(),
                       [&](const Sample& s) { return drive.pieces[s.leg].ref == ref; });
}

/// The first sample after the tool was down.
const Sample& rising_from(const Drive& drive) {
  const auto down =
      std::find_if(drive.samples.begin(), drive.samples.end(), [](const Sample& s) { return s.tool_down; });
  return *std::find_if(down, drive.samples.end(), [](const Sample& s) { return !s.tool_down; });
}

/// Seconds from a place on the run-in, the line y = 6 m, to the start of swath 2 at x = 50 m.
double run_in_s(const Drive& drive, double run_in_m) {
  const auto begin = std::find_if(drive.samples.begin(), drive.samples.end(), [&](const Sample& s) {
    return distance_m(s.at, {50 + run_in_m, 6}) < 1e-6;
  });
  REQUIRE(begin != drive.samples.end());
  return start_of(drive, "2").t_s - begin->t_s;
}

}  // namespace

TEST_CASE("the tool changes exactly where the work begins and ends", "[plan][drive]") {
  const Machine m = with_tool(1, 2, GENERATE(0.0, 3.0));
  const Drive drive = drive_of(two_swaths(m), m);
  for (const Sample& sample : drive.samples) {
    const std::string& ref = drive.pieces[sample.leg].ref;
    CHECK(sample.tool_down == !ref.empty());
  }
  CHECK(start_of(drive, "1").at == Point{0, 0});
  CHECK(rising_from(drive).at == Point{50, 0});
  CHECK(distance_m(start_of(drive, "2").at, {50, 6}) < 1e-9);
  CHECK(start_of(drive, "2").tool_down);
}

TEST_CASE("the tool comes down on the run-in without a stop", "[plan][drive]") {
  const double lower_s = GENERATE(0.5, 2.0, 12.0);
  const Machine m = with_tool(1, lower_s, 3);
  const Drive drive = drive_of(two_swaths(m), m);
  CAPTURE(lower_s);
  CHECK(waits_of(drive) == std::vector<double>{lower_s, 1});  // before the first swath, after the last
  CHECK(run_in_s(drive, 3) >= lower_s * (1 - 1e-9));
  CHECK(start_of(drive, "2").speed_mps > 0.2);
}

TEST_CASE("the machine stands for what a short run-in does not cover", "[plan][drive]") {
  const Machine m = with_tool(0, 4, 0.3);
  const Drive drive = drive_of(two_swaths(m), m);
  CHECK(waits_of(drive).size() == 2);
  CHECK(waits_of(drive).at(1) == Approx(4 - 0.3 / m.max_speed_mps));
  CHECK(run_in_s(drive, 0.3) >= 4);
  CHECK(start_of(drive, "2").speed_mps == 0);
}

TEST_CASE("without a run-in the machine stands until the tool is down", "[plan][drive]") {
  const Machine m = with_tool(0, 4, 0);
  CHECK(waits_of(drive_of(two_swaths(m), m)) == std::vector<double>{4, 4});
}

TEST_CASE("the tool rises while the machine drives on, but is up before it reverses", "[plan][drive]") {
  const Machine m = with_tool(2.5, 0, 0);
  const Drive onwards = drive_of(two_swaths(m), m);
  CHECK(waits_of(onwards) == std::vector<double>{2.5});  // after the last swath
  CHECK(rising_from(onwards).speed_mps > 0);
  const Drive back = drive_of(with_reverse(), m);
  CHECK(waits_of(back) == std::vector<double>{2.5, 2.5});
  const auto reversing = std::find_if(back.samples.begin(), back.samples.end(), [&](const Sample& s) {
    return back.pieces[s.leg].leg.stretch.gear == Gear::reverse;
  });
  CHECK(reversing->t_s >= rising_from(back).t_s + 2.5);
}

TEST_CASE("a tool still rising where it must come down again is given the time", "[plan][drive]") {
  const Machine m = with_tool(60, 4, 0);
  const Drive drive = drive_of(two_swaths(m), m);
  REQUIRE(waits_of(drive).size() == 3);
  CHECK(waits_of(drive).at(1) < 64);
  CHECK(start_of(drive, "2").t_s - rising_from(drive).t_s >= 64);
}

TEST_CASE("between pieces of work that meet the tool stays down", "[plan][drive]") {
  const Machine m = with_tool(2, 4, 0);
  const Route route{{{PieceKind::swath, "1", {{line({0, 0}, {50, 0})}}},
                     {PieceKind::headland_pass, "H1", {{line({50, 0}, {90, 0})}}}},
                    {},
                    {},
                    {}};
  CHECK(waits_of(drive_of(route, m)) == std::vector<double>{4, 2});
}
