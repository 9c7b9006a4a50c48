// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "verify_mutants.hpp"

namespace selion {
namespace {

constexpr double kTick_s = 1e-4;  // the last decimal of times

/// One row of a trajectory's samples.
struct Row {
  double share;  ///< of the way from the sample before to that after
  double t_s;
  double speed_mps;
  int tool;
};

template <class Suits>
std::optional<std::size_t> some_interval(const TrajectoryRecord& t, Dice& dice, Suits suits) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i + 1 < t.line.size(); ++i)
    if (suits(i)) all.push_back(i);
  if (all.empty()) return std::nullopt;
  return all[dice.pick(all.size())];
}

/// Work straight ahead at one speed for three seconds and more.
std::optional<std::size_t> some_cruise(const TrajectoryRecord& t, Dice& dice) {
  return some_interval(t, dice, [&](std::size_t i) {
    return t.tool[i] == 1 && t.curvature_per_m[i] == 0 && t.curvature_per_m[i + 1] == 0 &&
           t.speed_mps[i] == t.speed_mps[i + 1] && t.speed_mps[i] > 0.5 && t.t_s[i + 1] - t.t_s[i] > 3;
  });
}

template <class Value>
void insert(std::vector<Value>& into, std::size_t after, std::size_t count, Value value) {
  into.insert(into.begin() + static_cast<std::ptrdiff_t>(after) + 1, count, value);
}

/// Puts samples behind one, and has those after them `later_s` later.
void add_rows(TrajectoryRecord& t, std::size_t i, const std::vector<Row>& rows, double later_s) {
  const LonLat a = t.line[i];
  const LonLat b = t.line[i + 1];
  for (std::size_t k = i + 1; k < t.t_s.size(); ++k) t.t_s[k] += later_s;
  t.duration_s += later_s;
  insert(t.line, i, rows.size(), a);
  for (auto* numbers : {&t.t_s, &t.heading_rad, &t.curvature_per_m, &t.speed_mps})
    insert(*numbers, i, rows.size(), (*numbers)[i]);
  insert(t.tool, i, rows.size(), t.tool[i]);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::size_t at = i + 1 + k;
    t.line[at] = {a.lon_deg + rows[k].share * (b.lon_deg - a.lon_deg),
                  a.lat_deg + rows[k].share * (b.lat_deg - a.lat_deg)};
    t.t_s[at] = rows[k].t_s, t.speed_mps[at] = rows[k].speed_mps, t.tool[at] = rows[k].tool;
  }
}

/// Slower, from one moment to the next, for some time.
bool jump(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const auto i = some_cruise(t, dice);
  if (!i) return false;
  const double from = t.t_s[*i];
  const double span = t.t_s[*i + 1] - from;
  const double speed = t.speed_mps[*i];
  const double slow = speed * dice.between(0.2, 0.8);
  const double later = 0.4 * span * (speed / slow - 1);
  const double tick = kTick_s / span;
  add_rows(t, *i,
           {{0.3, from + 0.3 * span, speed, 1},
            {0.3 + tick, from + 0.3 * span + kTick_s, slow, 1},
            {0.7, from + 0.7 * span + later, slow, 1},
            {0.7 + tick, from + 0.7 * span + later + kTick_s, speed, 1}},
           later);
  return true;
}

/// A row of samples a millimetre or two apart.
std::vector<Row> crowd(const TrajectoryRecord& t, std::size_t i, double apart_m, double apart_s, int tool) {
  constexpr int kCount = 200;
  const double way = t.speed_mps[i] * (t.t_s[i + 1] - t.t_s[i]);
  const double begin = t.t_s[i] + 0.3 * (t.t_s[i + 1] - t.t_s[i]);
  std::vector<Row> rows;
  for (int k = 0; k <= kCount; ++k)
    rows.push_back({0.3 + k * apart_m / way, begin + k * apart_s, t.speed_mps[i], k < kCount ? tool : 1});
  return rows;
}

/// Faster by its times than by its speeds.
bool hurry(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const auto i = some_cruise(t, dice);
  if (!i) return false;
  const std::vector<Row> rows = crowd(t, *i, 1e-3, kTick_s, 1);
  const double rest = 0.7 * (t.t_s[*i + 1] - t.t_s[*i]) - 0.2 / t.speed_mps[*i];
  add_rows(t, *i, rows, rows.back().t_s + rest - t.t_s[*i + 1]);
  return true;
}

/// The tool up among samples that are near each other.
bool raise_in_a_crowd(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const auto i = some_cruise(t, dice);
  if (!i) return false;
  constexpr double kApart_m = 1.5e-3;
  add_rows(t, *i, crowd(t, *i, kApart_m, kApart_m / t.speed_mps[*i], 0), 0);
  return true;
}

PieceRecord part_of(PieceRecord whole, double from_m, double length_m) {
  whole.x_m += from_m * std::cos(whole.heading_rad), whole.y_m += from_m * std::sin(whole.heading_rad);
  whole.length_m = length_m;
  return whole;
}

/// A straight piece of work cut in its middle, other pieces of `apart_m` in between.
bool cut(PlanFile& plan, Dice& dice, double apart_m, std::vector<PieceRecord> (*between)(PieceRecord)) {
  std::vector<PieceRecord>& pieces = plan.trajectories[dice.pick(plan.trajectories.size())].pieces;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].tool == 1 && pieces[i].length_m > 8 && pieces[i].curvature_per_m == 0 &&
        pieces[i].sharpness_per_m2 == 0)
      all.push_back(i);
  if (all.empty()) return false;
  const std::size_t i = all[dice.pick(all.size())];
  const PieceRecord whole = pieces[i];
  const double half = whole.length_m / 2;
  std::vector<PieceRecord> parts = between(part_of(whole, half, 0));
  parts.insert(parts.begin(), part_of(whole, 0, half));
  parts.push_back(part_of(whole, half + apart_m, half - apart_m));
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
  pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(i), parts.begin(), parts.end());
  return true;
}

/// A wait of no time, which no sample knows of.
std::vector<PieceRecord> no_wait(PieceRecord at) {
  at.kind = "wait", at.tool = 0, at.duration_s = 0;
  at.ref.clear();
  return {at};
}

constexpr double kCrumb_m = 9e-4;

/// To one side and back by clothoids shorter than a millimetre.
std::vector<PieceRecord> wiggle(PieceRecord at) {
  constexpr double kSharp_per_m2 = 200;
  constexpr double kTurned_rad = kSharp_per_m2 * kCrumb_m * kCrumb_m / 2;
  std::vector<PieceRecord> crumbs;
  const auto add = [&](double turned_rad, double curvature_per_m, double sharpness_per_m2) {
    PieceRecord crumb = part_of(at, kCrumb_m * static_cast<double>(crumbs.size()), kCrumb_m);
    crumb.heading_rad += turned_rad;
    crumb.curvature_per_m = curvature_per_m, crumb.sharpness_per_m2 = sharpness_per_m2;
    crumbs.push_back(crumb);
  };
  add(0, 0, kSharp_per_m2);
  add(kTurned_rad, kSharp_per_m2 * kCrumb_m, -kSharp_per_m2);
  add(2 * kTurned_rad, 0, -kSharp_per_m2);
  add(kTurned_rad, -kSharp_per_m2 * kCrumb_m, kSharp_per_m2);
  return crumbs;
}

bool wait_no_time(PlanFile& plan, Dice& dice) { return cut(plan, dice, 0, no_wait); }
bool wiggle_in_crumbs(PlanFile& plan, Dice& dice) { return cut(plan, dice, 4 * kCrumb_m, wiggle); }

/// Curvature with the vehicle's left as positive.
double steered(const PieceRecord& piece, double along_m) {
  return piece.gear * (piece.curvature_per_m + along_m * piece.sharpness_per_m2);
}

/// The wheels turn in no time where the machine rests for them.
bool steer_at_once(PlanFile& plan, Dice& dice) {
  constexpr double kRest_s = 0.01;
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  std::vector<PieceRecord>& p = t.pieces;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    const double wait_s = p[k].kind == "wait" ? p[k].duration_s.value_or(0) : 0;
    if (wait_s < 0.2 || std::abs(steered(p[k + 1], 0) - steered(p[k - 1], p[k - 1].length_m)) < 0.05)
      continue;
    const auto rest = some_interval(t, dice, [&](std::size_t i) {
      return t.speed_mps[i] == 0 && t.speed_mps[i + 1] == 0 &&
             std::abs(t.t_s[i + 1] - t.t_s[i] - wait_s) < 2e-4;
    });
    if (!rest) continue;
    p[k].duration_s = kRest_s;
    for (std::size_t i = *rest + 1; i < t.t_s.size(); ++i) t.t_s[i] -= wait_s - kRest_s;
    t.duration_s -= wait_s - kRest_s;
    return true;
  }
  return false;
}

/// Back to where a line began, tool up, and along it once more.
bool work_again(PlanFile& plan, Dice& dice) {
  std::vector<PieceRecord>& pieces = plan.trajectories[dice.pick(plan.trajectories.size())].pieces;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].kind != "swath" || pieces[k].length_m < 8) continue;
    PieceRecord back = pieces[k];
    back.kind = "transfer", back.tool = 0, back.gear = -1;
    back.x_m += back.length_m * std::cos(back.heading_rad),
        back.y_m += back.length_m * std::sin(back.heading_rad);
    back.heading_rad += std::numbers::pi;
    const PieceRecord again = pieces[k];
    pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(k) + 1, {back, again});
    return true;
  }
  return false;
}

/// A closed pass, driven from its begin to its begin once more.
bool round_again(PlanFile& plan, Dice& dice) {
  std::vector<PieceRecord>& pieces = plan.trajectories[dice.pick(plan.trajectories.size())].pieces;
  for (const HeadlandPassRecord& pass : plan.headland_passes) {
    if (!(pass.line.front() == pass.line.back())) continue;
    const auto is_of = [&](const PieceRecord& piece) { return piece.ref == pass.id; };
    const auto first = std::ranges::find_if(pieces, is_of);
    const auto last = std::find_if_not(first, pieces.end(), is_of);
    if (first == last) continue;
    const std::vector<PieceRecord> again(first, last);
    pieces.insert(last, again.begin(), again.end());
    return true;
  }
  return false;
}

const std::vector<Mutation>& hidden() {
  static const std::vector<Mutation> all{
      {"a jump of speed within a tenth of a millisecond", {"acceleration"}, jump},
      {"times of a crowd of samples that are too short", {"sample_speed"}, hurry},
      {"a tool raised within a crowd of samples", {"sample_tool"}, raise_in_a_crowd},
      {"clothoids shorter than a millimetre", {"steering_rate"}, wiggle_in_crumbs},
      {"a line by way of elsewhere",
       {"swath_line"},
       to_one(&PlanFile::swaths,
              [](SwathRecord& swath, Dice& d) {
                swath.line.insert(swath.line.begin() + 1,
                                  {swath.line[0].lon_deg + d.between(1e-6, 1e-3), swath.line[0].lat_deg});
              })},
      {"a wait of no time", {"rest"}, wait_no_time},
      {"wheels that turn in no time", {"steering_rate"}, steer_at_once},
      {"a swath worked again", {"driven_twice"}, work_again},
      {"a pass driven round twice", {"driven_twice"}, round_again},
      {"a line that leads to and fro",
       {"line_length"},
       to_one(&PlanFile::headland_passes,
              [](HeadlandPassRecord& pass, Dice&) {
                const LonLatLine line = pass.line;
                pass.line.insert(pass.line.end(), line.rbegin() + 1, line.rend());
                pass.line.insert(pass.line.end(), line.begin() + 1, line.end());
              })},
  };
  return all;
}

}  // namespace

std::span<const Mutation> hidden_mutations() { return hidden(); }

}  // namespace selion
