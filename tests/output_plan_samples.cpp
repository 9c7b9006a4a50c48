// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_plan_samples.hpp"

#include "planfile_samples.hpp"

using namespace selion;

namespace {

BlockReport planned_block() {
  BlockReport block;
  block.number = 1;
  block.area_m2 = 80'000;
  block.covered_m2 = 79'600;
  block.twice = {100, 200, 300, 400};
  const LonLatArea corner{{{3.4, 46.3}, {3.5, 46.3}, {3.5, 46.4}}, {}};
  block.uncovered = {{corner, {3.45, 46.35}, 250.5}, {corner, {3.46, 46.35}, 149.5}};
  block.bearing_deg = 12.5;
  block.swaths = 60;
  block.pieces = 65;
  block.headland_passes = 3;
  block.headland_depth_m = 9;
  block.turn_depth_m = 6.25;
  block.work_m = 26'000;
  block.turn_m = 2'000;
  block.transfer_m = 500;
  block.reverse_m = 40;
  block.work_s = 17'000;
  block.turn_s = 2'000;
  block.transfer_s = 300;
  block.turns = 59;
  block.transfers = 4;
  block.pivots = 2;
  block.scrub_m = 1.5;
  return block;
}

BlockReport partial_block() {
  BlockReport block;
  block.number = 2;
  block.area_m2 = 10'000;
  block.covered_m2 = 8'999;
  block.bearing_deg = 90;
  block.swaths = 5;
  block.pieces = 5;
  block.headland_passes = 1;
  block.headland_depth_m = 3;
  block.work_m = 3'000;
  block.work_s = 2'000;
  return block;
}

BlockReport refused_block() {
  BlockReport block;
  block.number = 3;
  block.area_m2 = 1'000;
  block.refused = "the block is 4.1 m wide, a U-turn needs 9.3 m";
  return block;
}

}  // namespace

Plan reported_plan() {
  Plan plan;
  plan.file = sample_plan();
  plan.blocks = {planned_block(), partial_block(), refused_block()};
  plan.notes = {"1 spike removed"};
  plan.assumptions = {"Flat ground", "Boundary accuracy unknown"};
  return plan;
}
