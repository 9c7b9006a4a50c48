// SPDX-License-Identifier: GPL-3.0-or-later
#include "describe.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "selion/core/format.hpp"
#include "selion/core/units.hpp"
#include "selion/core/version.hpp"
#include "selion/motion/standing.hpp"
#include "selion/plan/job_file.hpp"

namespace selion {
namespace {

constexpr double kDatumWarning_m = 1;

/// The cleaned area as text, to the tenth of a millimetre: the input that the plan's id stands for.
std::string cleaned_text(const LocalFrame& frame, const Blocks& cleaned) {
  std::string text = frame.proj() + "\n";
  const auto add = [&](const Ring& ring) {
    for (const Point p : ring) text += fixed(p.x_m, 4) + " " + fixed(p.y_m, 4) + "\n";
    text += "\n";
  };
  for (const Block& block : cleaned.blocks)
    for (const Polygon* area : {&block.area, &block.free}) {
      add(area->shell);
      for (const Ring& hole : area->holes) add(hole);
    }
  return text;
}

std::string length_text(double m, const Job& job) {
  return job.output.units == "imperial" ? fixed(feet_of_m(m), 2) + " ft" : fixed(m, 2) + " m";
}

void assume(Plan& plan, const Field& field, const Job& job) {
  const auto say = [&plan](std::string text) { plan.assumptions.push_back(std::move(text)); };
  say((job.machine_assumed ? "Machine: none was given, preset " : "Machine: ") + job.machine.preset +
      (job.machine_assumed ? " is assumed, " : ", ") + length_text(job.machine.working_width_m, job) +
      " wide, turning radius " + length_text(1 / max_curvature_per_m(job.machine), job) +
      ". Mounted tools only.");
  say("Flat ground: slopes are not considered.");
  say(job.field.boundary_accuracy_m
          ? "Boundary accurate to " + length_text(*job.field.boundary_accuracy_m, job) + ", as the job says."
          : std::string{"Boundary accuracy unknown: drive the boundary once with RTK before relying on the "
                        "edge margin of "} +
                length_text(job.field.edge_margin_m, job) + ".");
  say("Datum of the boundary: " + (field.datum.empty() ? std::string{"WGS 84"} : field.datum) +
      (field.datum_accuracy_m.value_or(0) > 0
           ? ", converted to WGS 84 within " + length_text(*field.datum_accuracy_m, job)
           : std::string{}) +
      ". The machine's corrections must use the same datum.");
}

void warn(Plan& plan, const Field& field) {
  if (field.datum_accuracy_m && *field.datum_accuracy_m > kDatumWarning_m)
    plan.file.warnings.push_back("The step from " + field.datum + " to WGS 84 is only accurate to " +
                                 fixed(*field.datum_accuracy_m, 1) +
                                 " m: see the notes for the missing grid.");
}

/// A place inside the part: its centroid, or where that lies outside, the middle of its longest inner span
/// there.
Point place_in(const Polygon& part) {
  const Point middle = centroid(part);
  if (contains(part, middle)) return middle;
  const Box box = bounds(part.shell);
  const Point a{box.low.x_m - 1, middle.y_m};
  Point best = part.shell.front();
  double longest = 0;
  for (const Span1& span : inside_spans(a, {box.high.x_m + 1, middle.y_m}, {part})) {
    if (span.to_m - span.from_m <= longest) continue;
    longest = span.to_m - span.from_m;
    best = {a.x_m + (span.from_m + span.to_m) / 2, middle.y_m};
  }
  return best;
}

/// Time spent on each leg. A sample stands at every joint, as the end of one leg or the start of the next.
std::vector<double> seconds_of(std::size_t legs, const std::vector<Sample>& samples) {
  std::vector<double> spent(legs, 0);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const Sample& before = samples[k - 1];
    const Sample& after = samples[k];
    spent[after.s_m > 0 ? after.leg : before.leg] += after.t_s - before.t_s;
  }
  return spent;
}

void report_coverage(BlockReport& report, const Coverage& coverage, const LocalFrame& frame) {
  report.covered_m2 = coverage.covered_m2;
  report.twice = coverage.twice;
  for (const Polygon& part : coverage.uncovered)
    report.uncovered.push_back({to_lonlat(frame, part), frame.to_lonlat(place_in(part)), area_m2(part)});
}

/// Of swaths that are driven, the strips that they are pieces of.
int strips_driven(const Layout& layout, const Route& route) {
  std::set<std::string> driven;
  for (const RoutePiece& piece : route.pieces) driven.insert(piece.ref);
  std::set<int> strips;
  for (const Swath& swath : layout.swaths)
    if (driven.contains(swath.id)) strips.insert(swath.strip);
  return static_cast<int>(strips.size());
}

void report_layout(BlockReport& report, const Layout& layout, const LocalFrame& frame) {
  report.bearing_deg = true_bearing_deg(frame, layout.ab.a, heading_rad(layout.ab.b - layout.ab.a));
  report.headland_depth_m = layout.headland_depth_m;
  report.turn_depth_m = layout.turn_depth_m;
  report.headland_passes = layout.passes;
}

void count_pieces(BlockReport& report, const Route& route) {
  for (const RoutePiece& piece : route.pieces) {
    if (piece.kind == PieceKind::swath) ++report.pieces;
    if (piece.kind == PieceKind::turn) ++report.turns;
    if (piece.kind == PieceKind::transfer) ++report.transfers;
  }
}

void add_leg(double& sum_m, double& sum_s, double length_m, double spent_s) {
  sum_m += length_m;
  sum_s += spent_s;
}

void report_drive(BlockReport& report, const Drive& drive, const Machine& machine) {
  const std::vector<double> spent_s = seconds_of(drive.pieces.size(), drive.samples);
  for (std::size_t i = 0; i < drive.pieces.size(); ++i) {
    const DrivePiece& piece = drive.pieces[i];
    const double length = piece.leg.stretch.curve.length_m;
    if (piece.leg.tool_down)
      add_leg(report.work_m, report.work_s, length, spent_s[i]);
    else if (piece.kind == "turn" || piece.kind == "pivot" || piece.kind == "wait")
      add_leg(report.turn_m, report.turn_s, length, spent_s[i]);
    else
      add_leg(report.transfer_m, report.transfer_s, length, spent_s[i]);
    if (piece.leg.stretch.gear == Gear::reverse) report.reverse_m += length;
    if (!is_pivot(piece.leg.stretch)) continue;
    ++report.pivots;
    report.scrub_m += scrub_m(machine, piece.leg.stretch.pivot_rad);
  }
}

}  // namespace

Plan described(const Field& field, const Job& job, const LocalFrame& frame, const Blocks& cleaned) {
  Plan plan;
  plan.file.version = version();
  plan.file.proj = frame.proj();
  plan.file.origin = frame.origin();
  plan.file.job_json = job_json(job);
  plan.file.id = plan_id(cleaned_text(frame, cleaned), plan.file.job_json);
  plan.notes = field.notes;
  plan.notes.insert(plan.notes.end(), cleaned.notes.begin(), cleaned.notes.end());
  FieldRecord record{{}, field.name, 0, plan.notes};
  for (const Block& block : cleaned.blocks) {
    record.parts.push_back(to_lonlat(frame, block.area));
    for (const BlockGate& gate : block.gates)
      plan.file.gates.push_back({block.number, frame.to_lonlat(gate.at), gate.name, gate.width_m});
    record.area_m2 += area_m2(block.area);
  }
  if (cleaned.blocks.size() > 1)
    plan.notes.push_back("The field has " + std::to_string(cleaned.blocks.size()) +
                         " blocks, each with its own route; the way between blocks is not planned.");
  plan.file.fields.push_back(std::move(record));
  assume(plan, field, job);
  warn(plan, field);
  return plan;
}

std::string block_name(const Block& block, const Blocks& all) {
  return all.blocks.size() > 1 ? "block " + std::to_string(block.number) + ": " : std::string{};
}

namespace {

std::optional<std::size_t> named_gate(const Block& block, const std::string& start) {
  for (std::size_t i = 0; i < block.gates.size(); ++i)
    if (start == "gate:" + std::to_string(block.gates[i].number)) return i;
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> gate_of(const Block& block, const std::string& start) {
  if (block.gates.empty()) return std::nullopt;
  return named_gate(block, start).value_or(0);
}

void check_start(const Blocks& blocks, const std::string& start) {
  if (start.empty()) return;
  std::string there;
  for (const Block& block : blocks.blocks) {
    if (named_gate(block, start)) return;
    for (const BlockGate& gate : block.gates)
      there += (there.empty() ? "" : ", ") + std::string{"gate:"} + std::to_string(gate.number) +
               (gate.name.empty() ? "" : " (" + gate.name + ")");
  }
  throw InputError{"route.start = \"" + start + "\": the field has no such gate; " +
                   (there.empty() ? "it has none" : "there is " + there)};
}

BlockReport refused(const Block& block, const Infeasible& why) {
  BlockReport report;
  report.number = block.number;
  report.area_m2 = area_m2(block.area);
  report.refused = why.reason;
  return report;
}

BlockReport report_of(const PlannedBlock& planned, const Drive& drive, const LocalFrame& frame,
                      const Job& job) {
  BlockReport report;
  report.number = planned.block.number;
  report.area_m2 = area_m2(planned.block.area);
  report_coverage(report, planned.coverage, frame);
  report_layout(report, planned.layout, frame);
  report.swaths = strips_driven(planned.layout, planned.route);
  count_pieces(report, planned.route);
  report_drive(report, drive, job.machine);
  return report;
}

std::vector<std::string> notes_of(const PlannedBlock& planned) {
  std::vector<std::string> notes = planned.layout.notes;
  notes.insert(notes.end(), planned.route.notes.begin(), planned.route.notes.end());
  if (planned.block.gates.empty())
    notes.emplace_back(
        "No gate was given: the drive starts where the first work is and ends where the work is done.");
  std::string ids;
  for (const std::string& id : planned.route.left_out) ids += (ids.empty() ? "" : ", ") + id;
  if (!ids.empty()) notes.push_back("Left out, for the machine finds no way there and back: " + ids + ".");
  const std::string where = "Block " + std::to_string(planned.block.number) + ": ";
  for (std::string& note : notes) note.insert(0, where);
  return notes;
}

void summarise(Plan& plan) {
  BlockReport all;
  for (const BlockReport& block : plan.blocks) {
    all.area_m2 += block.area_m2;
    all.covered_m2 += block.covered_m2;
    all.twice.last_strip_m2 += block.twice.total_m2();
    all.work_m += block.work_m, all.turn_m += block.turn_m, all.transfer_m += block.transfer_m;
    all.work_s += block.work_s, all.turn_s += block.turn_s, all.transfer_s += block.transfer_s;
    all.swaths += block.swaths, all.pieces += block.pieces;
    if (!block.refused.empty())
      plan.file.warnings.push_back("Block " + std::to_string(block.number) + " (" +
                                   fixed(block.area_m2 / 1e4, 2) + " ha) is not planned: " + block.refused);
    else if (block.covered_m2 < kPlannedShare * block.area_m2)
      plan.file.warnings.push_back("Block " + std::to_string(block.number) + " is only partly planned: " +
                                   fixed(100 * block.covered_m2 / block.area_m2, 1) + " % of it is covered.");
  }
  plan.file.summary = {{"area_m2", all.area_m2},
                       {"covered_m2", all.covered_m2},
                       {"worked_twice_m2", all.twice.last_strip_m2},
                       {"swaths", 1.0 * all.swaths},
                       {"pieces", 1.0 * all.pieces},
                       {"work_m", all.work_m},
                       {"turn_m", all.turn_m},
                       {"transfer_m", all.transfer_m},
                       {"work_s", all.work_s},
                       {"turn_s", all.turn_s},
                       {"transfer_s", all.transfer_s}};
}

}  // namespace selion
