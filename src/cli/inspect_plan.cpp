// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "inspect.hpp"
#include "selion/core/format.hpp"
#include "selion/core/json_writer.hpp"
#include "selion/core/units.hpp"
#include "selion/plan/text.hpp"
#include "terminal.hpp"

namespace selion::cli {
namespace {

struct KindTotal {
  int count = 0;
  double length_m = 0;
};

struct PlanTotals {
  std::set<int> blocks;
  double area_m2 = 0, length_m = 0, duration_s = 0, width_m = 0;
  std::map<std::string, KindTotal> pieces;
};

PlanTotals totals_of(const PlanFile& plan) {
  PlanTotals totals;
  for (const FieldRecord& field : plan.fields) totals.area_m2 += field.area_m2;
  for (const TrajectoryRecord& trajectory : plan.trajectories) {
    totals.blocks.insert(trajectory.block);
    totals.length_m += trajectory.length_m;
    totals.duration_s += trajectory.duration_s;
    totals.width_m = trajectory.working_width_m;
    for (const PieceRecord& piece : trajectory.pieces) {
      KindTotal& kind = totals.pieces[piece.kind];
      ++kind.count;
      kind.length_m += piece.length_m;
    }
  }
  return totals;
}

/// The preset named in the job, the only key of that name.
std::string preset_of(const PlanFile& plan) {
  const std::string start = R"("preset":")";
  const std::size_t at = plan.job_json.find(start);
  if (at == std::string::npos) return "not named";
  const std::size_t from = at + start.size();
  return plan.job_json.substr(from, plan.job_json.find('"', from) - from);
}

std::string field_names(const PlanFile& plan) {
  std::string names;
  for (const FieldRecord& field : plan.fields) names += (names.empty() ? "" : ", ") + printable(field.name);
  return names;
}

std::string length_text(double m, Units units) {
  return units == Units::imperial ? fixed(feet_of_m(m), 0) + " ft" : fixed(m, 0) + " m";
}

}  // namespace

std::string text_of(const PlanFile& plan, Units units) {
  const PlanTotals totals = totals_of(plan);
  const std::string area = units == Units::imperial ? fixed(acres_of_m2(totals.area_m2), 2) + " ac"
                                                    : fixed(hectares_of_m2(totals.area_m2), 2) + " ha";
  std::string out = "plan " + printable(plan.id) + " by selion " + printable(plan.version) + ", format " +
                    std::to_string(plan.format) + "\n";
  out += "   field    " + field_names(plan) + ", " + area + "\n";
  out += "   machine  " + printable(preset_of(plan)) + ", working width " +
         (units == Units::imperial ? fixed(feet_of_m(totals.width_m), 1) + " ft"
                                   : number_text(totals.width_m) + " m") +
         "\n";
  out += "   blocks   " + std::to_string(totals.blocks.size()) + ", swaths " +
         std::to_string(plan.swaths.size()) + ", headland passes " +
         std::to_string(plan.headland_passes.size()) + "\n";
  out += "   path     " + length_text(totals.length_m, units) + " in " + fixed(totals.duration_s, 0) + " s\n";
  for (const auto& [kind, total] : totals.pieces)
    out += "   pieces   " + std::to_string(total.count) + " " + printable(kind) + ", " +
           length_text(total.length_m, units) + "\n";
  for (const SummaryFigure& figure : plan.summary)
    out += "   figure   " + printable(figure.key) + " " + number_text(figure.value) + "\n";
  for (const std::string& warning : plan.warnings) out += "   warning  " + printable(warning) + "\n";
  return out;
}

std::string json_of(const PlanFile& plan, const std::string& file) {
  const PlanTotals totals = totals_of(plan);
  JsonWriter json;
  json.begin_object(JsonSpread::lines)
      .key("file")
      .text(file)
      .key("kind")
      .text("plan")
      .key("id")
      .text(plan.id);
  json.key("version").text(plan.version).key("format").whole(plan.format);
  json.key("fields").begin_array(JsonSpread::line);
  for (const FieldRecord& field : plan.fields) json.text(field.name);
  json.end().key("area_m2").number(totals.area_m2, 1);
  json.key("blocks").whole(static_cast<long long>(totals.blocks.size()));
  json.key("swaths").whole(static_cast<long long>(plan.swaths.size()));
  json.key("headland_passes").whole(static_cast<long long>(plan.headland_passes.size()));
  json.key("length_m").number(totals.length_m, 4).key("duration_s").number(totals.duration_s, 4);
  json.key("pieces").begin_array(JsonSpread::lines);
  for (const auto& [kind, total] : totals.pieces)
    json.begin_object(JsonSpread::line)
        .key("kind")
        .text(kind)
        .key("count")
        .whole(total.count)
        .key("length_m")
        .number(total.length_m, 4)
        .end();
  json.end().key("job").raw(plan.job_json.empty() ? "null" : plan.job_json);
  json.key("summary").begin_object(JsonSpread::lines);
  for (const SummaryFigure& figure : plan.summary) json.key(figure.key).number(figure.value, 4);
  json.end().key("warnings").begin_array(JsonSpread::lines);
  for (const std::string& warning : plan.warnings) json.text(warning);
  return json.end().end().str() + "\n";
}

}  // namespace selion::cli
