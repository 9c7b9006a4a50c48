// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "check.hpp"
#include "segments.hpp"

namespace selion::verifying {
namespace {

constexpr double kLine_m = 0.02;  // of a line from what is driven: roundings, and chords of its curves

/// Pieces one after the other with the same id.
struct Stint {
  const Driven* driven = nullptr;
  std::size_t first = 0;
  std::size_t last = 0;
};
using Key = std::pair<int, std::string>;

/// A way between pieces of work is on none, whatever it names.
bool is_on_a_line(const PieceRecord& piece) {
  return piece.kind != "turn" && piece.kind != "transfer" && piece.kind != "pivot";
}

using Stints = std::map<Key, std::vector<Stint>>;

void add_stints(const Driven& driven, Stints& stints) {
  std::string before;
  for (std::size_t i = 0; i < driven.pieces.size(); ++i) {
    const PieceRecord& piece = driven.pieces[i].record();
    if (piece.kind == "wait") continue;
    if (!is_on_a_line(piece)) {
      before.clear();
      continue;
    }
    auto& all = stints[{driven.record->block, piece.ref}];
    if (all.empty() || piece.ref != before) all.push_back({&driven, i, i});
    all.back().last = i;
    before = piece.ref;
  }
}

Stints stints_of(const Case& plan) {
  Stints stints;
  for (const Driven& driven : plan.drives) add_stints(driven, stints);
  return stints;
}

/// Places of the axle, or of what lies `ahead_m` before it, every decimetre and less.
std::vector<Point> line_driven(const Stint& stint, double ahead_m) {
  constexpr double kStep_m = 0.1;
  std::vector<Point> line;
  for (std::size_t i = stint.first; i <= stint.last; ++i) {
    const PieceLine& piece = stint.driven->pieces[i];
    const int steps = piece.straight() ? 1 : static_cast<int>(std::ceil(piece.length_m() / kStep_m));
    for (int k = line.empty() ? 0 : 1; k <= steps; ++k)
      line.push_back(placed(piece.vehicle(piece.length_m() * k / std::max(1, steps)), {ahead_m, 0}));
  }
  return line;
}

/// How far the farthest of some places lies from a line.
double off_line_m(const std::vector<Point>& places, const std::vector<Point>& from) {
  return Segments{{from}}.farthest_m(places);
}

/// Of what is driven, times a line's own length.
double rounds(const std::vector<Point>& driven, const std::vector<Point>& line) {
  const auto length_of = [](const std::vector<Point>& places) {
    double sum = 0;
    for (std::size_t i = 1; i < places.size(); ++i) sum += distance_m(places[i - 1], places[i]);
    return sum;
  };
  return length_of(driven) / std::max(length_of(line), kLine_m);
}

class LineCheck {
 public:
  explicit LineCheck(Case& plan) : plan_{plan}, stints_{stints_of(plan)} {}

  void run() {
    for (const SwathRecord& swath : plan_.plan.swaths)
      if (const Stint* stint = the_one(swath.block, swath.id, swath.line)) check_swath(swath, *stint);
    for (const HeadlandPassRecord& pass : plan_.plan.headland_passes)
      if (const Stint* stint = the_one(pass.block, pass.id, pass.line)) check_pass(pass, *stint);
    for (const auto& [key, stints] : stints_)
      plan_.findings.add("unknown_line", key.first,
                         stints.front().driven->pieces[stints.front().first].spot(0).at, {1, 0},
                         (key.second.empty() ? "a line without a name" : key.second) +
                             " is driven, but the plan has no such line");
    check_order();
  }

 private:
  /// Taken out of the stints. None where the line is not driven once; that is told.
  const Stint* the_one(int block, const std::string& id, const LonLatLine& line) {
    const auto found = stints_.find({block, id});
    const std::size_t times = found == stints_.end() ? 0 : found->second.size();
    if (times != 1) {
      plan_.findings.add(times == 0 ? "not_driven" : "driven_twice", block,
                         plan_.plane.to_local(line.front()), {1.0 * static_cast<double>(times), 1},
                         id + " is driven " + std::to_string(times) + " times");
      if (times > 0) stints_.erase(found);
      return nullptr;
    }
    kept_ = found->second.front();
    stints_.erase(found);
    firsts_[{block, id}] = {kept_.driven, kept_.first};
    return &kept_;
  }

  void check_swath(const SwathRecord& swath, const Stint& stint) {
    const std::vector<Point> line = plan_.plane.to_local(swath.line);
    const Point a = line.front();
    const Point b = line.back();
    std::vector<Point> tool = line_driven(stint, plan_.vehicle.machine.tool_x_m);
    if (distance_m(tool.front(), a) > distance_m(tool.front(), b)) std::ranges::reverse(tool);
    const double off = std::max({distance_m(tool.front(), a), distance_m(tool.back(), b),
                                 off_line_m(tool, line), off_line_m(line, tool)});
    if (!(off <= kLine_m))
      plan_.findings.add("swath_line", swath.block, a, {off, kLine_m},
                         "swath " + swath.id + " is driven " + shown(off, 3) + " m off its line");
    goes_once(swath.block, swath.id, tool, line);
    check_measures(swath.block, swath.id, a, {swath.length_m, distance_m(a, b)}, swath.width_m);
  }

  void check_measures(int block, const std::string& id, Point at, Measured length, double width_m) {
    if (!(std::abs(length.measure - length.limit) <= kLine_m))
      plan_.findings.add("line_length", block, at, length,
                         id + " is said to be " + shown(length.measure, 3) + " m long, its line is " +
                             shown(length.limit, 3) + " m");
    const double wide = plan_.vehicle.machine.working_width_m;
    if (!(std::abs(width_m - wide) <= 1e-3))
      plan_.findings.add(
          "line_width", block, at, {width_m, wide},
          id + " is said to be " + shown(width_m, 3) + " m wide, the tool is " + shown(wide, 3) + " m");
  }

  void check_pass(const HeadlandPassRecord& pass, const Stint& stint) {
    const std::vector<Point> line = plan_.plane.to_local(pass.line);
    const std::vector<Point> driven = line_driven(stint, 0);
    const double off = std::max({off_line_m(line, driven), distance_m(line.front(), driven.front()),
                                 distance_m(line.back(), driven.back()), off_line_m(driven, line) - kLine_m});
    if (!(off <= kLine_m))
      plan_.findings.add("pass_line", pass.block, line.front(), {off, kLine_m},
                         "headland pass " + pass.id + " is driven " + shown(off, 3) + " m off its line");
    goes_once(pass.block, pass.id, driven, line);
    check_measures(pass.block, pass.id, line.front(), {0, 0}, pass.width_m);
  }

  /// Neither to and fro, nor round and round: as long as its line, which may not lead there twice either.
  void goes_once(int block, const std::string& id, const std::vector<Point>& driven,
                 const std::vector<Point>& line) {
    constexpr double kMost = 1.5;
    const double times = rounds(driven, line);
    if (times > kMost)
      plan_.findings.add("driven_twice", block, line.front(), {times, 1},
                         id + " is driven " + shown(times, 2) + " times without a break");
    if (times < 1 / kMost)
      plan_.findings.add(
          "line_length", block, line.front(), {1 / times, 1},
          "the line of " + id + " is " + shown(1 / times, 2) + " times as long as what is driven");
  }

  /// Swaths stand in the order in which they are driven, from 1.
  void check_order() {
    std::map<std::pair<int, const Driven*>, std::vector<std::pair<std::size_t, const SwathRecord*>>> driven;
    for (const SwathRecord& swath : plan_.plan.swaths) {
      const auto first = firsts_.find({swath.block, swath.id});
      if (first != firsts_.end())
        driven[{swath.block, first->second.first}].emplace_back(first->second.second, &swath);
    }
    for (auto& [key, swaths] : driven) {
      std::ranges::sort(swaths);
      for (std::size_t i = 0; i < swaths.size(); ++i)
        if (swaths[i].second->order != static_cast<int>(i) + 1)
          plan_.findings.add("swath_order", key.first, plan_.plane.to_local(swaths[i].second->line.front()),
                             {1.0 * swaths[i].second->order, 1.0 * static_cast<double>(i) + 1},
                             "swath " + swaths[i].second->id + " is said to be number " +
                                 std::to_string(swaths[i].second->order) +
                                 " of its block, and driven as number " + std::to_string(i + 1));
    }
  }

  Case& plan_;
  Stints stints_;
  std::map<Key, std::pair<const Driven*, std::size_t>> firsts_;
  Stint kept_;
};

}  // namespace

void check_lines(Case& plan) { LineCheck{plan}.run(); }

}  // namespace selion::verifying
