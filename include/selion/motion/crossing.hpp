// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "selion/core/point.hpp"
#include "selion/motion/path.hpp"

namespace selion {

enum class Meeting {
  crossing,  ///< the one passes through the other, or ends on it
  touching,  ///< side by side to within 1e-9 m at one place, or crossing twice within 1e-4 m of it
  overlap    ///< side by side to within 2e-9 m from here to the meeting that follows in the list
};

/// Where two curves meet.
struct Crossing {
  double first_m = 0;   ///< station on the first curve
  double second_m = 0;  ///< station on the second curve
  Point at;
  Meeting meeting = Meeting::crossing;
};

/// All places where the curves meet, by station on the first. Complete: pairs of stretches are left out only
/// where their chords, widened by k L^2 / 8, stay apart (Sederberg and Nishita 1990, fat lines), or where
/// the one keeps its distance beside the other; they are searched by Newton's method where no tangents are
/// parallel, so that they meet once at most. Where the curves run side by side, an overlap's two ends are
/// listed. Between 1e-9 m and 2e-9 m apart, that may or may not be called an overlap.
///
/// Parts of one and the same curve give the two ends of what they share, and nothing else: not where
/// a circle of more than a turn comes round again.
/// @pre lengths of at most 1e4 m.
std::vector<Crossing> crossings(const Curve& first, const Curve& second);

}  // namespace selion
