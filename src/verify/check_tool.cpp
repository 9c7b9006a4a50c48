// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "check.hpp"

namespace selion::verifying {
namespace {

constexpr double kNear_m = 1e-3;  // of a joint, as a sample belongs to it
constexpr double kSlack_s = 5e-3;

/// Has the tool the time that it takes to go down and up, where it may (docs/plan.md)?
class ToolCheck {
 public:
  ToolCheck(Case& plan, const Driven& driven)
      : plan_{plan}, driven_{driven}, machine_{plan.vehicle.machine} {}

  void run() {
    if (driven_.moments.empty()) return;
    for (std::size_t i = 0; i < driven_.pieces.size(); ++i) {
      const bool was_down = i > 0 && down(i - 1);
      if (down(i) && !was_down) lowered(i);
      if (!down(i) && was_down) up_s_ = arrival_s(i), risen_ = false;
      if (up_s_ && !risen_ && (driven_.pieces[i].record().gear < 0 || pivots(i))) risen(i, begin_s(i));
    }
    if (up_s_ && !risen_) risen(driven_.pieces.size() - 1, driven_.moments.back().t_s);
  }

 private:
  [[nodiscard]] bool down(std::size_t i) const { return driven_.pieces[i].record().tool == 1; }
  [[nodiscard]] bool pivots(std::size_t i) const { return driven_.pieces[i].record().kind == "pivot"; }

  /// When the robot comes to where piece i begins, and when it leaves that place.
  [[nodiscard]] double arrival_s(std::size_t i) const {
    const auto at =
        std::ranges::lower_bound(driven_.moments, driven_.begin_m[i] - kNear_m, {}, &Moment::way_m);
    return at == driven_.moments.end() ? driven_.moments.back().t_s : at->t_s;
  }
  [[nodiscard]] double leaving_s(std::size_t i) const { return departure_s(driven_, driven_.begin_m[i]); }

  /// A pivot begins when what is waited before it is over.
  [[nodiscard]] double begin_s(std::size_t i) const {
    if (!pivots(i)) return leaving_s(i);
    double begin = arrival_s(i);
    for (std::size_t k = i; k > 0 && driven_.pieces[k - 1].stands(); --k)
      begin += driven_.pieces[k - 1].record().duration_s.value_or(0);
    return begin;
  }

  /// From where on it may be lowered before piece i: where it stands, or rolls straight ahead.
  [[nodiscard]] double lowering_from_s(std::size_t i) const {
    const double end = driven_.begin_m[i];
    std::size_t k = i;
    const auto straight_ahead = [&](const PieceLine& p) {
      return p.stands() ? p.record().kind == "wait" : p.straight() && p.record().gear > 0;
    };
    while (k > 0 && !down(k - 1) && straight_ahead(driven_.pieces[k - 1])) --k;
    const double from = std::max(driven_.begin_m[k], end - machine_.run_in_m);
    return from < end - kNear_m ? time_s(driven_, from) : arrival_s(i);
  }

  void lowered(std::size_t i) {
    const double begin = leaving_s(i);
    say("tool_lowering", i, {begin - lowering_from_s(i), machine_.tool_lower_s}, "to be lowered before");
    if (up_s_ && !risen_) risen(i, begin - machine_.tool_lower_s);
  }

  void risen(std::size_t i, double by_s) {
    say("tool_raising", i, {by_s - *up_s_, machine_.tool_raise_s}, "to be raised before, or at the end of,");
    risen_ = true;
  }

  void say(const char* code, std::size_t i, Measured span, const std::string& what) {
    if (span.limit == 0 || span.measure >= span.limit - kSlack_s) return;
    plan_.findings.add(code, driven_.record->block, driven_.pieces[i].spot(0).at, span,
                       "the tool has " + shown(span.measure, 2) + " s " + what + " " +
                           piece_name(driven_, i) + "; it takes " + shown(span.limit, 2) + " s");
  }

  Case& plan_;
  const Driven& driven_;
  const Machine& machine_;
  std::optional<double> up_s_;  ///< since when it is going up
  bool risen_ = false;
};

}  // namespace

void check_tool(Case& plan, const Driven& driven) { ToolCheck{plan, driven}.run(); }

}  // namespace selion::verifying
