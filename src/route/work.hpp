// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "chains.hpp"
#include "driver.hpp"
#include "ring_order.hpp"
#include "selion/core/progress.hpp"

namespace selion {

/// The order in which a driver works a layout's pieces: each of the functions drives what it can reach and
/// keeps the rest for later.
class Work {
 public:
  Work(Driver& driver, const Layout& layout);

  /// Chain by chain, the nearest end first, each back and forth.
  void swaths(const Progress& progress);
  /// Pockets, and what was put off, nearest first.
  void pockets();
  /// Ring by ring, around one obstacle after the other, from the border in, to end near the first swath, or
  /// out to the border, to end near the gate, if there is one.
  void headland_inwards();
  void headland_outwards(const std::optional<Point>& gate);
  /// Once more what was put off.
  void put_off();
  /// Ids of what was put off and not reached since.
  [[nodiscard]] std::vector<std::string> left() const;

 private:
  /// Where a chain is begun.
  struct Entry {
    std::size_t chain = 0;
    bool at_last = false;
    Sense sense = Sense::forth;
  };

  [[nodiscard]] Entry nearest_entry(const std::vector<Chain>& chains) const;
  bool work_chain(Chain::const_iterator next, Chain::const_iterator end, Sense sense);
  bool work_one_of(std::vector<Chain>& chains);
  [[nodiscard]] Sense sense_beside(const Swath& swath) const;
  [[nodiscard]] Task task_of(const Swath& swath) const;
  [[nodiscard]] double nearness_m(const Task& task) const;
  void work_nearest(std::vector<Task> tasks);
  bool work_one_of(std::vector<Task>& tasks);
  [[nodiscard]] bool split(const Task& task, std::vector<Task>& into) const;
  [[nodiscard]] bool split_all(std::vector<Task>& tasks) const;
  void work_rings(RingOrder order, const std::vector<Point>& at_last, const std::optional<Point>& last_near);
  bool work_pass(const HeadlandPass& pass);
  bool work_round(const HeadlandPass& pass);
  void keep_near_gate(Task& task) const;
  bool work_parts(const HeadlandPass& pass);
  [[nodiscard]] Task pass_task(const HeadlandPass& pass) const;
  bool work_turned(const HeadlandPass& pass);
  bool drive_on_to(const Task& task);

  Driver& driver_;
  const Layout& layout_;
  bool either_way_round_;  ///< may every closed pass be driven both ways round?
  std::vector<Point>
      then_to_;  ///< where the machine goes after the ring being worked; empty: to the next ring
  std::optional<Point> ends_near_;  ///< the gate, once the passes lead out to it
  std::vector<Task> put_off_;
  std::vector<std::string> dead_ends_;  ///< ids of what was taken back
};

}  // namespace selion
