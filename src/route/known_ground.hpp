// SPDX-License-Identifier: GPL-3.0-or-later
// What searches for ways find out about the ground and leave to those after them: many begin at the same
// places, or seek the same goals.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "selion/core/point.hpp"
#include "selion/motion/path.hpp"

namespace selion {

/// A turn between these poses.
struct PosePair {
  Pose from;
  Pose to;

  friend bool operator==(const PosePair&, const PosePair&) = default;
};

/// Of their exact bits.
struct PoseHash {
  std::size_t operator()(const Pose& pose) const {
    std::uint64_t hash = 0;
    for (const double number : {pose.at.x_m, pose.at.y_m, pose.heading_rad})
      hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15ULL >> 7 ^ hash << 13;
    return hash;
  }
  std::size_t operator()(const PosePair& pair) const {
    return (*this)(pair.from) * 0x9e3779b97f4a7c15ULL ^ (*this)(pair.to);
  }
};

/// Of the moves of a search from one pose, numbered as it has them: one bit each.
struct TriedMoves {
  std::uint32_t tried = 0;
  std::uint32_t inside = 0;  ///< of those tried, the ones that stay inside
};

/// The turn soon found between two poses, as far as it has been asked for.
struct KnownTurn {
  std::optional<Path> turn;  ///< none: there is none
  bool is_all = false;       ///< turns with stops too have been looked for, where the machine may drive them
};

struct KnownGround {
  std::unordered_map<Pose, TriedMoves, PoseHash> moves;
  std::unordered_map<PosePair, KnownTurn, PoseHash> turns;
};

}  // namespace selion
