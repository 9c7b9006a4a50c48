// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "connect.hpp"
#include "roads.hpp"
#include "selion/route/route.hpp"
#include "task.hpp"

namespace selion {

/// One machine on its way through one block: where it stands, what it has driven, and how it gets to the next
/// task. Refers to the layout and the machine that it is given, and adds to what is known of the ground.
class Driver {
 public:
  Driver(const Block& block, const Layout& layout, const Machine& machine, KnownGround& known);

  [[nodiscard]] const Terrain& terrain() const { return terrain_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  /// Absent while it has neither been placed nor driven anything: then it may begin anywhere.
  [[nodiscard]] const std::optional<Pose>& here() const { return here_; }
  [[nodiscard]] const std::vector<RoutePiece>& driven() const { return driven_; }

  void stand_at(std::optional<Pose> pose) { here_ = pose; }
  /// Drives to the task by one turn and works it; false where there is none, or a long one only.
  bool turn_to(const Task& task);
  /// Drives to the task by the cheapest of its ways and works it; false where it cannot be reached.
  bool drive_to(const Task& task);
  /// The same with the task, of several, that is reached most cheaply: which one. The nearest ones first.
  std::optional<std::size_t> drive_to_one_of(const std::vector<Task>& tasks);
  /// Drives a way that begins where it stands and leads to the task's first one, and works it.
  void drive_along(const Path& way, const Task& task);
  /// Takes the last work back, with the way to it; what was taken back, last piece last. Empty where there is
  /// none, or where nobody knows where the machine stood before it.
  std::vector<RoutePiece> take_back();
  void drive_again(std::vector<RoutePiece> pieces);
  /// Drives from where it stands to `goal` without working; false where no way is found.
  bool drive_out_to(const Pose& goal);

 private:
  struct Approach {
    std::size_t goal = 0;  ///< which of the goals
    Path way;
    double cost_m = 0;
  };

  struct Goal {
    Pose pose;
    double rest_m = 0;  ///< what follows costs so much more than after the best goal
  };

  [[nodiscard]] std::optional<Approach> approach(const std::vector<Goal>& goals);
  [[nodiscard]] std::optional<Approach> straight_into(const std::vector<Goal>& goals) const;
  [[nodiscard]] std::optional<Approach> turn_into(const std::vector<Goal>& goals);
  [[nodiscard]] std::optional<Approach> turn_into(const std::vector<Goal>& goals, const Swings& swings,
                                                  double most_m, std::size_t most_goals) const;
  [[nodiscard]] std::optional<Approach> turn_into(const std::vector<Goal>& goals, std::size_t most_goals);
  [[nodiscard]] std::optional<Approach> turn_anyhow_into(const std::vector<Goal>& goals);
  [[nodiscard]] std::optional<Approach> turn_led_into(const std::vector<Goal>& goals) const;
  [[nodiscard]] std::optional<Approach> shortcut(const std::vector<Pose>& goals, double most_m);
  [[nodiscard]] std::optional<Approach> turn_slowly_into(const std::vector<Goal>& goals);
  [[nodiscard]] const Swings& swings(double wider);
  [[nodiscard]] const Swings& slower_swings(double speed_mps);
  [[nodiscard]] Approach or_ahead(Approach way, const Pose& goal);
  [[nodiscard]] std::optional<Approach> by(std::optional<Arrival> arrival) const;
  [[nodiscard]] Roads& roads();
  [[nodiscard]] std::vector<Goal> goals_of(const Task& task, double run_in_m) const;
  [[nodiscard]] std::vector<double> run_ins_m() const;
  void drive_by(const Task& task, const std::vector<Goal>& goals, Approach approach);
  void work(const Task& task, const Path& way, const Path& work);
  [[nodiscard]] std::vector<Path> ways_back() const;
  [[nodiscard]] Pose before(const Pose& start, double run_in_m) const;
  [[nodiscard]] double longest_turn_m() const;

  const Layout& layout_;
  const Machine& machine_;
  KnownGround& known_;
  FreeSpace space_;
  AreaIndex mainland_;
  Terrain terrain_;
  std::optional<Roads> roads_;
  std::map<double, Swings> wider_;
  std::map<double, Swings> slower_;
  std::optional<Pose> here_;
  std::vector<RoutePiece> driven_;
  unsigned shortcuts_in_vain_ = 0;  // in a row
};

}  // namespace selion
