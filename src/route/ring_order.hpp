// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "selion/layout/layout.hpp"

namespace selion {

enum class RingSense { inwards, outwards };  ///< away from the border or obstacle, or towards it

/// Which headland passes may be worked next: each comes after those beside it that lie one ring further out
/// (inwards) or further in (outwards). So all the rings around one obstacle are worked before the machine
/// goes on to the next.
class RingOrder {
 public:
  /// Refers to the layout. `width_m`: between neighbouring passes.
  RingOrder(const Layout& layout, double width_m, RingSense sense);

  [[nodiscard]] bool empty() const;
  /// The nearest pass that may be worked next; where `last_near` is given, the one nearest to it comes last.
  /// @pre not empty.
  [[nodiscard]] std::size_t nearest(const std::optional<Point>& here,
                                    const std::optional<Point>& last_near) const;
  [[nodiscard]] const HeadlandPass& pass(std::size_t i) const { return *entries_[i].pass; }
  void done(std::size_t i);
  /// Once i is done: is none that may be worked next beside it?
  [[nodiscard]] bool ends_group(std::size_t i) const;
  /// May one only be worked next? Then all that are left come after it.
  [[nodiscard]] bool is_last_group() const;
  /// Places on all passes that may be worked next.
  [[nodiscard]] std::vector<Point> next_places() const;

 private:
  struct Entry {
    const HeadlandPass* pass = nullptr;
    std::vector<Point> places;        ///< along it, a few widths apart
    std::vector<std::size_t> before;  ///< beside it, to be worked first
    bool is_done = false;
  };
  void find_neighbours(double width_m, int step);
  [[nodiscard]] bool ready(const Entry& entry) const;
  [[nodiscard]] static double far_m(const Entry& entry, Point p);

  std::vector<Entry> entries_;
};

}  // namespace selion
