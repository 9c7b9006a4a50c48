// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "selion/field/frame.hpp"
#include "selion/geometry/polygon.hpp"

namespace selion {

/// Edges of a ring whose boxes meet, found by a tree of boxes around neighbours. Edge i leads from corner i.
class NearEdges {
 public:
  explicit NearEdges(const Ring& ring);

  using Visit = std::function<bool(std::size_t, std::size_t)>;
  /// Each pair once, until `visit` returns false. @returns false where it did.
  [[nodiscard]] bool each_pair(const Visit& visit) const;

 private:
  [[nodiscard]] bool within(std::size_t level, std::size_t i, const Visit& visit) const;
  [[nodiscard]] bool between(std::size_t level, std::size_t i, std::size_t k, const Visit& visit) const;
  [[nodiscard]] std::size_t end_of(std::size_t level, std::size_t i) const;

  std::vector<std::vector<Box>> levels_;  ///< the first of edges, each other of some boxes before it
};

/// Where the insides of two edges cross: shares along a-b and c-d.
std::optional<std::pair<double, double>> crossing(Point a, Point b, Point c, Point d);

/// Nobody can say what a scribble encloses, and to follow one takes long.
/// @throws InputError where the ring crosses itself, or runs beside itself, more often than any border does.
void refuse_tangle(const Ring& ring, const LocalFrame& frame, const std::string& where);

}  // namespace selion
