// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "check.hpp"

namespace selion::verifying {
namespace {

/// What is driven, by what it is for.
struct Sums {
  double work_m = 0, turn_m = 0, transfer_m = 0;
  double work_s = 0, turn_s = 0, transfer_s = 0;
};

void add(Sums& sums, const PieceRecord& piece, double way_m, double span_s) {
  const bool turns = piece.kind == "turn" || piece.kind == "pivot" || piece.kind == "wait";
  (piece.tool == 1 ? sums.work_m : turns ? sums.turn_m : sums.transfer_m) += way_m;
  (piece.tool == 1 ? sums.work_s : turns ? sums.turn_s : sums.transfer_s) += span_s;
}

void add_ways(Sums& sums, const Driven& driven) {
  for (std::size_t i = 0; i < driven.pieces.size(); ++i)
    add(sums, driven.pieces[i].record(), driven.begin_m[i + 1] - driven.begin_m[i], 0);
}

constexpr double kNear_m = 1e-3;

/// Does a piece begin here during which the machine waits or turns on the spot?
bool stands_near(const Driven& driven, double way_m) {
  auto begin = std::ranges::lower_bound(driven.begin_m, way_m - kNear_m);
  for (; begin != driven.begin_m.end() && *begin <= way_m + kNear_m; ++begin) {
    const auto i = static_cast<std::size_t>(begin - driven.begin_m.begin());
    if (i == driven.pieces.size()) break;
    const PieceRecord& piece = driven.pieces[i].record();
    if (piece.duration_s || piece.angle_rad) return true;
  }
  return false;
}

bool at_rest(const Moment& a, const Moment& b) {
  constexpr double kStill_mps = 1e-3;
  return b.way_m - a.way_m <= kNear_m / 2 && std::max(a.speed_mps, b.speed_mps) <= kStill_mps;
}

/// The time between two moments belongs to the piece that is driven between them; at rest, to the one that
/// stands.
void add_times(Sums& sums, const Driven& driven) {
  for (std::size_t i = 1; i < driven.moments.size(); ++i) {
    const Moment& a = driven.moments[i - 1];
    const Moment& b = driven.moments[i];
    if (!at_rest(a, b) || !stands_near(driven, a.way_m)) {
      add(sums, driven.pieces[driven.stop((a.way_m + b.way_m) / 2).piece].record(), 0, b.t_s - a.t_s);
      continue;
    }
    PieceRecord rest;
    rest.kind = "wait";
    add(sums, rest, 0, b.t_s - a.t_s);
  }
}

class SummaryCheck {
 public:
  SummaryCheck(Case& plan, const Verdict& verdict) : plan_{plan}, verdict_{verdict} {}

  void run() {
    for (const SummaryFigure& figure : plan_.plan.summary) figures_[figure.key] = figure.value;
    areas();
    counts();
    drives();
    for (const auto& [key, told] : figures_)
      plan_.findings.add(
          "summary", 0, std::nullopt, {told, 0},
          "the summary says " + key + " = " + shown(told, 2) + ", which no plan is known to have");
  }

 private:
  /// Takes it out of the figures: what is left at last is none that the plan has.
  void figure(const char* key, double found, double slack) {
    const auto node = figures_.extract(key);
    if (node.empty()) {
      plan_.findings.add("summary", 0, std::nullopt, {0, found}, std::string{"the summary has no "} + key);
      return;
    }
    const double told = node.mapped();
    if (std::abs(told - found) <= slack) return;
    plan_.findings.add(
        "summary", 0, std::nullopt, {told, found},
        std::string{"the summary says "} + key + " = " + shown(told, 2) + "; it is " + shown(found, 2));
  }

  void areas() {
    const double area = verdict_.area_m2;
    figure("area_m2", area, 0.01 + 1e-5 * area);
    figure("covered_m2", verdict_.covered_m2, 0.5 + 2e-4 * area);
    figure("worked_twice_m2", verdict_.twice_m2, 0.5 + 2e-4 * area + 0.01 * verdict_.twice_m2);
  }

  /// Swaths are counted by the strips that they are pieces of: "12a" and "12b" are one.
  void counts() {
    std::set<std::pair<int, int>> strips;
    for (const SwathRecord& swath : plan_.plan.swaths)
      if (const auto strip = strip_of(swath.id)) strips.emplace(swath.block, *strip);
    figure("swaths", static_cast<double>(strips.size()), 0.1);
    figure("pieces", static_cast<double>(plan_.plan.swaths.size()), 0.1);
  }

  void drives() {
    Sums sums;
    for (const Driven& driven : plan_.drives) {
      add_ways(sums, driven);
      add_times(sums, driven);
    }
    const double slack_m = 0.01 + 1e-6 * (sums.work_m + sums.turn_m + sums.transfer_m);
    figure("work_m", sums.work_m, slack_m);
    figure("turn_m", sums.turn_m, slack_m);
    figure("transfer_m", sums.transfer_m, slack_m);
    double slack_s = 0.05 + 1e-5 * (sums.work_s + sums.turn_s + sums.transfer_s);
    if (plan_.findings.any("sample_place") || plan_.findings.any("sample_speed"))
      slack_s = std::numeric_limits<double>::infinity();  // told already
    figure("work_s", sums.work_s, slack_s);
    figure("turn_s", sums.turn_s, slack_s);
    figure("transfer_s", sums.transfer_s, slack_s);
  }

  Case& plan_;
  const Verdict& verdict_;
  std::map<std::string, double> figures_;
};

}  // namespace

void check_summary(Case& plan, const Verdict& verdict) { SummaryCheck{plan, verdict}.run(); }

}  // namespace selion::verifying
