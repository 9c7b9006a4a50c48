// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "selion/motion/footprint.hpp"
#include "walk.hpp"

namespace selion {
namespace {

constexpr double kSweepStray_m = 0.003;  // of the tool's ends from the chords of the area swept

/// So short that neither end of the tool strays from its chord by more than kSweepStray_m.
double sweep_step_m(const Footprint& f, const Curve& curve) {
  return chord_m(curve, std::hypot(f.tool_x_m, f.half_tool_m), kSweepStray_m);
}

/// A strip while it grows: its right edge forwards, its left edge to be taken backwards.
class Strip {
 public:
  explicit Strip(std::vector<Ring>& into) : into_{into} {}

  void add(const Stand& from, const Stand& to, const Footprint& f) {
    const Corners corners = swept_across(from, to, f.tool_x_m, f.half_tool_m);
    if (!turns_left(corners)) {  // an end goes back: what lies between is the hull of both lines
      end();
      into_.push_back(convex_hull({corners.begin(), corners.end()}));
      return;
    }
    if (!right_.empty() && distance_m(right_.back(), corners[0]) > kJoint_m)
      end();  // turned about on the spot
    if (right_.empty()) {
      right_.push_back(corners[0]);
      left_.push_back(corners[3]);
      first_ = from.ahead;
    }
    right_.push_back(corners[1]);
    left_.push_back(corners[2]);
    if (dot(first_, to.ahead) < kMostTurned) end();
  }

  void end() {
    if (right_.empty()) return;
    right_.insert(right_.end(), left_.rbegin(), left_.rend());
    into_.push_back(std::move(right_));
    right_.clear();
    left_.clear();
  }

 private:
  static constexpr double kJoint_m = 1e-3;
  static constexpr double kMostTurned =
      -0.5;  // cosine of 120 degrees: turned less, a strip cannot meet itself

  std::vector<Ring>& into_;
  Ring right_;
  Ring left_;
  Point first_;
};

}  // namespace

std::vector<Ring> swept_by_tool(const Footprint& f, const Path& path) {
  std::vector<Ring> swept;
  Strip strip{swept};
  for (const Stretch& stretch : path) {
    if (is_pivot(stretch)) continue;  // the tool is up
    const double length = stretch.curve.length_m;
    const int steps = is_straight(stretch.curve)
                          ? 1
                          : std::max(1, static_cast<int>(std::ceil(length / sweep_step_m(f, stretch.curve))));
    Walk walk{stretch, steps};
    Stand before = walk.here();
    for (int i = 1; i <= steps; ++i) {
      walk.advance();
      const Stand after = walk.here();
      strip.add(before, after, f);
      before = after;
    }
  }
  strip.end();
  return swept;
}

}  // namespace selion
