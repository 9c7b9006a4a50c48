// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include "plan_fields.hpp"
#include "selion/core/format.hpp"
#include "selion/core/units.hpp"

namespace selion::cli {
namespace {

constexpr double kMetresOfMile = 1609.344;

struct Totals {
  double area_m2 = 0, planned_m2 = 0, covered_m2 = 0, length_m = 0, time_s = 0, work_s = 0;
  int swaths = 0, pieces = 0, passes = 0, planned = 0;
};

Totals totals_of(const Plan& plan) {
  Totals t;
  for (const BlockReport& block : plan.blocks) {
    t.area_m2 += block.area_m2;
    if (!block.refused.empty()) continue;
    t.planned_m2 += block.area_m2;
    t.covered_m2 += block.covered_m2;
    t.length_m += block.work_m + block.turn_m + block.transfer_m;
    t.time_s += block.work_s + block.turn_s + block.transfer_s;
    t.work_s += block.work_s;
    t.swaths += block.swaths;
    t.pieces += block.pieces;
    t.passes += block.headland_passes;
    ++t.planned;
  }
  return t;
}

std::string area_text(double m2, const Job& job) {
  return job.output.units == "imperial" ? fixed(acres_of_m2(m2), 2) + " ac"
                                        : fixed(hectares_of_m2(m2), 2) + " ha";
}

std::string length_text(double m, const Job& job) {
  return job.output.units == "imperial" ? fixed(m / kMetresOfMile, 2) + " mi" : fixed(m / 1000, 2) + " km";
}

std::string time_text(double s) {
  const long minutes = std::lround(s / 60);
  return minutes < 60 ? std::to_string(minutes) + " min"
                      : std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

std::string percent_text(double part, double whole) {
  return whole > 0 ? fixed(100 * part / whole, 1) + " %" : "0 %";
}

std::string counted(int number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

}  // namespace

std::string summary_text(const Task& task, const Outcome& outcome, const Job& job) {
  const std::string name = printable(task.field.name);
  if (!outcome.plan) return name + ": not planned\n";
  const Totals t = totals_of(*outcome.plan);
  const bool partial = t.covered_m2 < kPlannedShare * t.area_m2;
  const std::string blocks = outcome.plan->blocks.size() == 1
                                 ? ""
                                 : " in " + std::to_string(t.planned) + " of " +
                                       std::to_string(outcome.plan->blocks.size()) + " blocks";
  std::string out = name + ": " + (partial ? "partly planned" : "planned") + ", " +
                    area_text(t.area_m2, job) + blocks + ", " + percent_text(t.covered_m2, t.area_m2) +
                    " covered\n";
  out += "  " + counted(t.swaths, "swath", "swaths") + " (" + counted(t.pieces, "piece", "pieces") + "), " +
         counted(t.passes, "headland pass", "headland passes") + "\n";
  out += "  " + length_text(t.length_m, job) + " in " + time_text(t.time_s) + ", " +
         percent_text(t.work_s, t.time_s) + " of it working\n";
  out += "  in " + printable((task.folder / "").string()) + ": ";
  for (std::string_view file : output_names())
    out += (file == output_names().front() ? "" : ", ") + std::string{file};
  return out + "\n";
}

}  // namespace selion::cli
