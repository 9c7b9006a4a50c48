// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "parts.hpp"

namespace selion {

Polygons swept_by(const Footprint& footprint, const Path& path);

/// Strips of ground that the tool sweeps, each known by whose it is.
class SweptGround {
 public:
  explicit SweptGround(const Footprint& footprint) : footprint_{footprint} {}

  void add(const Path& path, std::size_t whose);
  void add(Ring ring, std::size_t whose);
  void remove(std::size_t whose);
  /// What of `whose` strips within `workable` no other strip sweeps.
  [[nodiscard]] Polygons swept_only_by(std::size_t whose, const Polygons& workable) const;

 private:
  struct Strip {
    Ring ring;
    Box box;
    std::size_t whose = 0;
  };

  const Footprint& footprint_;
  std::vector<Strip> strips_;
};

}  // namespace selion
