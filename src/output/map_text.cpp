// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "figures.hpp"
#include "quantity.hpp"
#include "selion/core/format.hpp"
#include "selion/output/report.hpp"

namespace selion {
namespace {

std::string title_of(const Plan& plan, const Job& job) {
  const std::string name = plan.file.fields.empty() ? std::string{} : plan.file.fields.front().name;
  return (name.empty() ? std::string{"Field"} : name) + " - " + std::string{name_of(job.operation)};
}

std::string share_text(double area_m2, double whole_m2, Units units) {
  return area_text(area_m2, units) + " (" + fixed(percent(area_m2, whole_m2), 1) + " %)";
}

using Rows = std::vector<std::pair<std::string, std::string>>;

struct Facts {
  const Plan& plan;
  const Job& job;
  Units units;
  BlockReport all;
  std::vector<BlockReport> planned;
};

Facts facts_of(const Plan& plan, const Job& job) {
  const Units units = job.output.units == "imperial" ? Units::imperial : Units::metric;
  std::vector<BlockReport> planned = plan.blocks;
  std::erase_if(planned, [](const BlockReport& block) { return status_of(block) == Status::refused; });
  return {plan, job, units, total(plan.blocks), std::move(planned)};
}

/// One text where all planned blocks say the same, else each block's own.
template <class Text>
std::string per_block(const Facts& facts, const Text& text) {
  if (facts.planned.empty()) return "none";
  std::string first = text(facts.planned.front());
  const auto is_first = [&](const BlockReport& block) { return text(block) == first; };
  if (std::ranges::all_of(facts.planned, is_first)) return first;
  std::string out;
  for (const BlockReport& block : facts.planned) {
    out += (out.empty() ? "" : "; ") + std::to_string(block.number) + ": " + text(block);
  }
  return out;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void add_areas(Rows& rows, const Facts& facts) {
  const double field_m2 = facts.all.area_m2;
  rows.emplace_back("Field area", area_text(field_m2, facts.units));
  const std::size_t blocks = facts.plan.blocks.size();
  const std::size_t refused = blocks - facts.planned.size();
  const std::string left_out = refused == 0 ? "" : ", " + std::to_string(refused) + " not planned";
  if (blocks > 1) rows.emplace_back("Blocks", std::to_string(blocks) + left_out);
  rows.emplace_back("Headland area", share_text(headland_m2(facts.plan.file), field_m2, facts.units));
  rows.emplace_back("Covered", share_text(facts.all.covered_m2, field_m2, facts.units));
  const std::size_t places = facts.all.uncovered.size() + refused;
  const std::string left = area_text(uncovered_m2(facts.plan.blocks), facts.units);
  if (places > 0) rows.emplace_back("Not covered", left + " in " + counted(places, "place", "places"));
  rows.emplace_back("Worked twice", share_text(facts.all.twice.total_m2(), field_m2, facts.units));
}

std::string swath_text(const Facts& facts, const SwathRecord& swath) {
  const std::string block = facts.plan.blocks.size() > 1 ? ", block " + std::to_string(swath.block) : "";
  return length_text(swath.length_m, 1, facts.units) + " (no. " + swath.id + block + ")";
}

void add_swaths(Rows& rows, const Facts& facts) {
  rows.emplace_back("Working width", length_text(facts.job.machine.working_width_m, 2, facts.units));
  rows.emplace_back("Heading A to B, true", per_block(facts, [](const BlockReport& block) {
                      return bearing_text(block.bearing_deg);
                    }));
  const std::string pieces =
      facts.all.pieces == facts.all.swaths ? "" : ", " + std::to_string(facts.all.pieces) + " pieces";
  rows.emplace_back("Swaths", std::to_string(facts.all.swaths) + pieces);
  const auto lengths = swath_lengths(facts.plan.file, std::nullopt);
  if (!lengths) return;
  rows.emplace_back("Longest swath", swath_text(facts, *lengths->longest));
  rows.emplace_back("Shortest swath", swath_text(facts, *lengths->shortest));
}

void add_headland(Rows& rows, const Facts& facts) {
  rows.emplace_back("Headland", per_block(facts, [&](const BlockReport& block) {
                      const auto passes = static_cast<std::size_t>(block.headland_passes);
                      return counted(passes, "pass", "passes") + ", " +
                             length_text(block.headland_depth_m, 1, facts.units);
                    }));
}

void add_drive(Rows& rows, const Facts& facts) {
  const BlockReport& all = facts.all;
  rows.emplace_back("Working distance", distance_text(all.work_m, facts.units));
  rows.emplace_back("Driving distance", distance_text(driven_m(all), facts.units));
  if (all.reverse_m > 0) rows.emplace_back("of it in reverse", distance_text(all.reverse_m, facts.units));
  rows.emplace_back("Turns", std::to_string(all.turns));
  rows.emplace_back("Time", time_text(driven_s(all)));
  rows.emplace_back("of it working", time_text(all.work_s));
}

void add_verification(Rows& rows, const Facts& facts) {
  const auto& said = facts.plan.verification;
  rows.emplace_back("Independent check", !said                  ? "not asked for"
                                         : said->faults.empty() ? "no fault found"
                                                                : "FAILED");
}

Rows data_box(const Facts& facts) {
  Rows rows;
  add_areas(rows, facts);
  add_swaths(rows, facts);
  add_headland(rows, facts);
  add_drive(rows, facts);
  add_verification(rows, facts);
  return rows;
}

/// What was planned otherwise than asked comes before repairs of the boundary: there may be no room for all.
std::vector<std::string> notes_for_driver(const Plan& plan) {
  std::vector<std::string> notes = plan.notes;
  std::stable_partition(notes.begin(), notes.end(),
                        [](const std::string& note) { return note.starts_with("Block "); });
  return notes;
}

}  // namespace

MapText map_text(const Plan& plan, const Job& job) {
  MapText text;
  text.title = title_of(plan, job);
  text.data = data_box(facts_of(plan, job));
  text.notes = notes_for_driver(plan);
  text.assumptions = plan.assumptions;
  text.warnings = plan.file.warnings;
  if (plan.verification && !plan.verification->faults.empty())
    text.warnings.insert(
        text.warnings.begin(),
        "Do not drive this plan: the independent check found a fault. " + plan.verification->faults.front());
  return text;
}

MapOptions map_options(const Job& job) {
  const Paper paper = job.output.paper == "A3"       ? Paper::a3
                      : job.output.paper == "letter" ? Paper::letter
                                                     : Paper::a4;
  return {.units = job.output.units == "imperial" ? Units::imperial : Units::metric, .paper = paper};
}

}  // namespace selion
