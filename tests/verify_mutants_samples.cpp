// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "verify_mutants.hpp"

namespace selion {
namespace {

using Change = void (*)(TrajectoryRecord&, std::size_t, Dice&);

/// One sample changed, neither the first nor the last.
std::function<bool(PlanFile&, Dice&)> to_sample(Change change) {
  return [change](PlanFile& plan, Dice& dice) {
    TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
    if (t.line.size() < 4) return false;
    change(t, 1 + dice.pick(t.line.size() - 2), dice);
    return true;
  };
}

double either(Dice& dice, double least, double most) {
  return dice.between(least, most) * (dice.pick(2) == 0 ? 1 : -1);
}

/// A sample within a bend, where they lie at most 0.25 m apart.
bool drop_in_bend(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  std::vector<std::size_t> all;
  for (std::size_t i = 2; i + 2 < t.line.size(); ++i)
    if (std::abs(t.curvature_per_m[i]) > 0.1 && std::abs(t.speed_mps[i]) > 0.3 &&
        t.t_s[i + 1] - t.t_s[i - 1] > 0.35 / std::abs(t.speed_mps[i]))
      all.push_back(i);
  if (all.empty()) return false;
  const auto i = static_cast<std::ptrdiff_t>(all[dice.pick(all.size())]);
  t.line.erase(t.line.begin() + i);
  for (auto* numbers : {&t.t_s, &t.heading_rad, &t.curvature_per_m, &t.speed_mps})
    numbers->erase(numbers->begin() + i);
  t.tool.erase(t.tool.begin() + i);
  return true;
}

bool drop_end(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const std::size_t keep = t.line.size() / 2 + dice.pick(t.line.size() / 2 - 1);
  t.line.resize(keep);
  for (auto* numbers : {&t.t_s, &t.heading_rad, &t.curvature_per_m, &t.speed_mps}) numbers->resize(keep);
  t.tool.resize(keep);
  return keep > 2;
}

/// As if driven faster: times and speeds agree.
bool drive_faster(PlanFile& plan, Dice& dice) {
  const double by = dice.between(1.1, 2);
  for (TrajectoryRecord& t : plan.trajectories) {
    for (double& time : t.t_s) time /= by;
    for (double& speed : t.speed_mps) speed *= by;
    t.duration_s /= by;
  }
  return true;
}

bool swap_times(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const std::size_t i = 1 + dice.pick(t.t_s.size() - 2);
  std::swap(t.t_s[i - 1], t.t_s[i]);
  return true;
}

/// The robot begins a second later than it says, and ends as much later.
bool begin_late(PlanFile& plan, Dice& dice) {
  TrajectoryRecord& t = plan.trajectories[dice.pick(plan.trajectories.size())];
  const double by = dice.between(0.5, 5);
  for (double& time : t.t_s) time += by;
  t.duration_s += by;
  return true;
}

bool second_robot(PlanFile& plan, Dice& dice) {
  TrajectoryRecord other = plan.trajectories[dice.pick(plan.trajectories.size())];
  other.robot = 2;
  plan.trajectories.push_back(other);
  return true;
}

const std::vector<Mutation>& of_samples() {
  static const std::vector<Mutation> all{
      {"move a sample", {"sample_place", "sample_speed"}, to_sample([](auto& t, std::size_t i, Dice& d) {
         t.line[i].lat_deg += either(d, 5e-8, 1e-5);
       })},
      {"turn a sample", {"sample_heading"}, to_sample([](auto& t, std::size_t i, Dice& d) {
         t.heading_rad[i] += either(d, 0.01, 3);
       })},
      {"bend a sample", {"sample_curvature"}, to_sample([](auto& t, std::size_t i, Dice& d) {
         t.curvature_per_m[i] += either(d, 0.01, 0.5);
       })},
      {"slow a sample down",
       {"sample_speed", "sample_place", "acceleration"},
       to_sample([](auto& t, std::size_t i, Dice& d) {
         t.speed_mps[i] += t.speed_mps[i] > 0.7 ? -d.between(0.2, 0.6) : d.between(0.5, 1);
       })},
      {"drive a sample the other way",
       {"sample_gear", "not_finished"},
       to_sample([](auto& t, std::size_t i, Dice&) {
         t.speed_mps[i] = std::abs(t.speed_mps[i]) > 0.01 ? -t.speed_mps[i] : 0.5;
       })},
      {"no gain of time", {"time_order"}, to_sample([](auto& t, std::size_t i, Dice&) {
         t.t_s[i] = t.t_s[i - 1];
       })},
      {"a sample a second later",
       {"sample_speed", "sample_place", "time_order", "rest"},
       to_sample([](auto& t, std::size_t i, Dice& d) { t.t_s[i] += d.between(0.5, 2); })},
      {"swap two times", {"time_order"}, swap_times},
      {"drop a sample in a bend", {"sample_gap", "sample_place", "sample_speed"}, drop_in_bend},
      {"drop the last samples", {"not_finished"}, drop_end},
      {"drive faster than the machine may",
       {"speed", "acceleration", "lateral", "steering_rate"},
       drive_faster},
      {"begin late", {"not_finished"}, begin_late},
      {"two robots through one point", {"robots_too_close", "block"}, second_robot},
  };
  return all;
}

}  // namespace

std::span<const Mutation> mutations_of_samples() { return of_samples(); }

}  // namespace selion
