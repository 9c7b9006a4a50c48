// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "verify_mutants.hpp"

namespace selion {
namespace {

template <class Record>
std::function<bool(PlanFile&, Dice&)> without(std::vector<Record> PlanFile::*records) {
  return [=](PlanFile& plan, Dice&) {
    (plan.*records).clear();
    return true;
  };
}

/// Another word for when the headland is worked.
bool order_headland(PlanFile& plan, const std::string& word) {
  const std::size_t table = plan.job_json.find(R"("headland":{)");
  const std::string order = R"("order":")";
  const std::size_t from = plan.job_json.find(order, table);
  if (table == std::string::npos || from == std::string::npos) return false;
  const std::size_t to = plan.job_json.find_first_of(",}", from);
  plan.job_json.replace(from, to - from, order + word + "\"");
  return true;
}

bool order_route(PlanFile& plan, const std::string& word) {
  const std::string route = R"("route":{"order":"adjacent")";
  const std::size_t from = plan.job_json.find(route);
  if (from == std::string::npos) return false;
  plan.job_json.replace(from, route.size(), R"("route":{"order":")" + word + "\"");
  return true;
}

bool cell_twice(PlanFile& plan, Dice& dice) {
  if (plan.cells.empty()) return false;
  CellRecord cell = plan.cells[dice.pick(plan.cells.size())];
  cell.id += "x";
  plan.cells.push_back(cell);
  return true;
}

bool leave_headland(PlanFile& plan, Dice&) { return order_headland(plan, "none"); }

bool turn_headland_order(PlanFile& plan, Dice&) {
  const PlanFile before = plan;
  return order_headland(plan, "first") && (plan != before || order_headland(plan, "last"));
}

/// Pieces of the line are of that kind and called so from now on.
void rename_pieces(PlanFile& plan, const SwathRecord& swath, const std::string& kind,
                   const std::string& ref) {
  for (TrajectoryRecord& t : plan.trajectories)
    for (PieceRecord& piece : t.pieces)
      if (t.block == swath.block && piece.ref == swath.id) piece.kind = kind, piece.ref = ref;
}

bool swath_as_pass(PlanFile& plan, Dice& dice) {
  const std::size_t i = dice.pick(plan.swaths.size());
  const SwathRecord swath = plan.swaths[i];
  if (swath.id.starts_with('P')) return false;
  plan.swaths.erase(plan.swaths.begin() + static_cast<std::ptrdiff_t>(i));
  plan.headland_passes.push_back({swath.block, "H9", 1, swath.line, swath.width_m});
  rename_pieces(plan, swath, "headland_pass", "H9");
  return true;
}

bool name_a_turn(PlanFile& plan, Dice& dice) {
  std::vector<PieceRecord>& pieces = plan.trajectories.front().pieces;
  PieceRecord& piece = pieces[dice.pick(pieces.size())];
  if (piece.tool == 1 || plan.swaths.empty()) return false;
  piece.ref = plan.swaths.front().id;
  return true;
}

/// A square of the headland, or of a cell, that neither has then.
bool hole_in(std::vector<LonLatArea>& parts, Dice& dice) {
  LonLatArea& part = parts[dice.pick(parts.size())];
  LonLat at;
  for (const LonLat p : part.shell) {
    at.lon_deg += p.lon_deg / static_cast<double>(part.shell.size());
    at.lat_deg += p.lat_deg / static_cast<double>(part.shell.size());
  }
  const double north = dice.between(0.25, 0.5) / 111320;
  const double east = north / std::cos(at.lat_deg * 0.017453292519943295);
  part.holes.push_back({{at.lon_deg - east, at.lat_deg - north},
                        {at.lon_deg - east, at.lat_deg + north},
                        {at.lon_deg + east, at.lat_deg + north},
                        {at.lon_deg + east, at.lat_deg - north}});
  return true;
}

bool drive_swath_as_pass(PlanFile& plan, Dice& dice) {
  const SwathRecord swath = plan.swaths[dice.pick(plan.swaths.size())];
  rename_pieces(plan, swath, "headland_pass", swath.id);
  return true;
}

double length_m(const LonLatLine& line) {
  constexpr double kDegree_m = 111'200;
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += kDegree_m * std::hypot(line[i].lat_deg - line[i - 1].lat_deg,
                                     (line[i].lon_deg - line[i - 1].lon_deg) *
                                         std::cos(line[i].lat_deg * std::numbers::pi / 180));
  return length;
}

/// A long one: short ones may lie in corners, with none further out beside them.
bool count_ring_one_less(PlanFile& plan, Dice& dice) {
  std::vector<HeadlandPassRecord*> long_ones;
  for (HeadlandPassRecord& pass : plan.headland_passes)
    if (pass.ring > 1 && length_m(pass.line) > 100) long_ones.push_back(&pass);
  if (long_ones.empty()) return false;
  --long_ones[dice.pick(long_ones.size())]->ring;
  return true;
}

bool all_passes_outermost(PlanFile& plan, Dice&) {
  for (HeadlandPassRecord& pass : plan.headland_passes) pass.ring = 1;
  return true;
}

/// Another value for a key of the job, where it has none of `unless`.
std::function<bool(PlanFile&, Dice&)> job(const std::string& key, const std::string& value,
                                          const std::string& unless = "none") {
  return [=](PlanFile& plan, Dice&) {
    const std::string start = "\"" + key + "\":";
    const std::size_t from = plan.job_json.find(start);
    if (from == std::string::npos) return false;
    const std::size_t to = plan.job_json.find_first_of(",}", from);
    if (plan.job_json.compare(from + start.size(), to - from - start.size(), unless) == 0) return false;
    plan.job_json.replace(from, to - from, start + value);
    return true;
  };
}

bool has_holes(const PlanFile& plan) { return !plan.fields.front().parts.front().holes.empty(); }

bool nearer_to_holes(PlanFile& plan, Dice& dice) {
  return has_holes(plan) && job("obstacle_clearance_m", "2.5")(plan, dice);
}

/// A plan along whole degrees may be one by that rule.
bool by_p3(PlanFile& plan, Dice& dice) {
  const double bearing = plan.ab_lines.front().bearing_deg;
  return std::abs(std::remainder(bearing, 1)) > 1e-3 && job("direction", "\"p3\"")(plan, dice);
}

PieceRecord wait_of(const TrajectoryRecord& t) {
  PieceRecord wait = t.pieces.front();
  wait.kind = "wait", wait.ref.clear(), wait.tool = 0;
  wait.length_m = wait.curvature_per_m = wait.sharpness_per_m2 = 0;
  wait.duration_s = 0;
  return wait;
}

/// For a robot that does not come, or not so far.
bool wait_for_ever(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  PieceRecord wait = wait_of(t);
  wait.for_robot = t.robot + static_cast<int>(dice.pick(2));
  wait.until_station_m = t.length_m / 2;
  t.pieces.insert(t.pieces.begin(), wait);
  return true;
}

/// The samples rest in their middle, no piece does.
bool rest_for_long(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const double by = dice.between(1, 1e6);
  for (std::size_t i = 1; i + 1 < t.line.size(); ++i) {
    if (t.speed_mps[i] != 0) continue;
    for (std::size_t k = i + 1; k < t.line.size(); ++k) t.t_s[k] += by;
    const auto at = static_cast<std::ptrdiff_t>(i);
    t.line.insert(t.line.begin() + at, t.line[i]);
    for (auto* numbers : {&t.t_s, &t.heading_rad, &t.curvature_per_m, &t.speed_mps})
      numbers->insert(numbers->begin() + at, (*numbers)[i]);
    t.t_s[i + 1] += by;
    t.tool.insert(t.tool.begin() + at, t.tool[i]);
    t.duration_s += by;
    return true;
  }
  return false;
}

const std::vector<Mutation>& of_layout() {
  using P = PlanFile;
  static const std::vector<Mutation> all{
      {"invent a figure of the summary",
       {"summary"},
       [](P& p, Dice&) {
         p.summary.push_back({"yield_t", 400});
         return true;
       }},
      {"move a gate off the border",
       {"gate"},
       to_one(&P::gates, [](auto& g, Dice& d) { g.at.lat_deg += d.between(1e-6, 1e-3); })},
      {"gates narrower than the body",
       {"gate"},
       [](P& p, Dice&) {
         for (GateRecord& gate : p.gates) gate.width_m = 0.3;
         return true;
       }},
      {"a gate of no block", {"block"}, to_one(&P::gates, [](auto& g, Dice&) { g.block = 8; })},
      {"begin at a gate that is not there", {"gate"}, job("start", "\"gate:7\"")},
      {"begin at another gate", {"gate"}, job("start", "\"gate:2\"")},
      {"turn an AB line",
       {"ab"},
       to_one(&P::ab_lines, [](auto& a, Dice& d) { a.b.lat_deg += d.between(2e-6, 1e-4); })},
      {"edit an AB line's bearing",
       {"ab"},
       to_one(&P::ab_lines, [](auto& a, Dice& d) { a.bearing_deg += d.between(0.01, 180); })},
      {"swap A and B",
       {"ab", "swath_direction"},
       to_one(&P::ab_lines, [](auto& a, Dice&) { std::swap(a.a, a.b); })},
      {"move an AB line aside",
       {"swath_spacing"},
       to_one(&P::ab_lines,
              [](auto& a, Dice& d) {
                const double by = d.between(1e-6, 1e-4);
                const LonLat way{a.b.lon_deg - a.a.lon_deg, a.b.lat_deg - a.a.lat_deg};
                const double far = std::hypot(way.lon_deg, way.lat_deg);
                const LonLat aside{-by * way.lat_deg / far, by * way.lon_deg / far};
                for (LonLat* end : {&a.a, &a.b}) end->lon_deg += aside.lon_deg, end->lat_deg += aside.lat_deg;
              })},
      {"drop the AB lines", {"ab"}, without(&P::ab_lines)},
      {"ask for another AB line", {"ab"}, job("ab", "[10,50,10.001,50.0005]")},
      {"ask for another bearing", {"ab"}, job("direction", "17.25")},
      {"edit a cell's bearing",
       {"ab"},
       to_one(&P::cells, [](auto& c, Dice& d) { c.bearing_deg += d.between(0.01, 90); })},
      {"rename a cell", {"cell"}, to_one(&P::cells, [](auto& c, Dice&) { c.id += "x"; })},
      {"drop the cells", {"cell", "headland"}, without(&P::cells)},
      {"a cell under two names", {"headland"}, cell_twice},
      {"a hole in a cell",
       {"headland"},
       [](PlanFile& plan, Dice& dice) {
         return !plan.cells.empty() && hole_in(plan.cells[dice.pick(plan.cells.size())].parts, dice);
       }},
      {"a turn that names a swath", {"line_kind"}, name_a_turn},
      {"move a cell",
       {"headland"},
       to_one(&P::cells,
              [](auto& c, Dice& d) {
                const double by = d.between(1e-6, 1e-4);
                for (LonLatArea& part : c.parts)
                  for (LonLat& p : part.shell) p.lat_deg += by;
              })},
      {"a swath of another cell", {"cell"}, to_one(&P::swaths, [](auto& s, Dice&) { s.cell += "7"; })},
      {"turn a swath's line round",
       {"swath_direction"},
       to_one(&P::swaths, [](auto& s, Dice&) { std::swap(s.line.front(), s.line.back()); })},
      {"edit the headland's depth",
       {"headland"},
       to_one(&P::headlands, [](auto& h, Dice& d) { h.depth_m += d.between(0.05, 3); })},
      {"edit the headland's passes", {"headland"}, to_one(&P::headlands, [](auto& h, Dice&) { ++h.passes; })},
      {"another ring of a pass", {"headland"}, to_one(&P::headland_passes, [](auto& p, Dice&) { ++p.ring; })},
      {"a ring of a pass one less", {"headland"}, count_ring_one_less},
      {"drop the headland", {"headland"}, without(&P::headlands)},
      {"leave the headland unworked", {"headland"}, leave_headland},
      {"work the headland the other way round", {"headland_order"}, turn_headland_order},
      {"a swath as a headland pass", {"headland", "line_kind"}, swath_as_pass},
      {"drive a swath as a headland pass", {"line_kind"}, drive_swath_as_pass},
      {"rename a headland pass",
       {"line_kind"},
       to_one(&P::headland_passes, [](auto& p, Dice&) { p.id = "7"; })},
      {"all headland passes outermost", {"headland"}, all_passes_outermost},
      {"another robot", {"robot"}, to_one(&P::trajectories, [](auto& t, Dice&) { ++t.robot; })},
      {"ask for more passes", {"headland"}, job("passes", "9")},
      {"ask for more overlap", {"swath_spacing"}, job("overlap_m", "0.12")},
      {"keep farther from the border", {"edge_margin", "headland"}, job("edge_margin_m", "0.6")},
      {"keep farther from holes", {"body_obstacle", "tool_obstacle", "path_outside"}, nearer_to_holes},
      {"pass over the border", {"job"}, job("overhang_m", "2")},
      {"an order of swaths of later versions", {"job"}, [](P& p, Dice&) { return order_route(p, "lands"); }},
      {"a direction of later versions", {"job"}, job("direction", "\"cost\"")},
      {"a direction by the rule p3", {"ab", "job"}, by_p3},
      {"an unknown preset", {"job"}, job("preset", "\"tractor-99m\"")},
      {"an unknown key of the machine", {"job"}, job("mass_kg", "9,\"colour\":1")},
      {"another frame by code", {"frame"}, job("crs", "\"EPSG:2154\"")},
      {"an unknown frame", {"frame"}, job("crs", "\"EPSG:999999\"")},
      {"an unknown operation", {"job"}, job("operation", "\"racing\"")},
      {"a tool slower to lower", {"tool_lowering"}, job("tool_lower_s", "9")},
      {"a tool slower to raise", {"tool_raising"}, job("tool_raise_s", "60")},
      {"a shorter run-in", {"tool_lowering"}, job("run_in_m", "0.2", "0")},
      {"wait for a robot that does not come", {"wait"}, wait_for_ever},
      {"rest where nothing stands", {"rest"}, rest_for_long},
  };
  return all;
}

}  // namespace

std::span<const Mutation> mutations_of_layout() { return of_layout(); }

}  // namespace selion
