// SPDX-License-Identifier: GPL-3.0-or-later
#include "chains.hpp"

#include <algorithm>

namespace selion {
namespace {

struct Along {
  double low_m;
  double high_m;
};

Along along_of(const Swath& swath, Point axis) {
  const double a = dot(swath.from, axis);
  const double b = dot(swath.to, axis);
  return {std::min(a, b), std::max(a, b)};
}

bool beside(const Swath& p, const Swath& q, Point axis) {
  const Along a = along_of(p, axis);
  const Along b = along_of(q, axis);
  return q.strip == p.strip + 1 && a.low_m < b.high_m && b.low_m < a.high_m;
}

/// The one piece of `others` beside `piece`, or null where there are none or several.
const Swath* only_neighbour(const Swath& piece, const std::vector<Swath>& others, Point axis, bool next) {
  const Swath* found = nullptr;
  for (const Swath& other : others) {
    if (!(next ? beside(piece, other, axis) : beside(other, piece, axis))) continue;
    if (found != nullptr) return nullptr;
    found = &other;
  }
  return found;
}

}  // namespace

std::vector<Chain> chains_of(const std::vector<Swath>& swaths, DrivingDirection along) {
  const Point axis = unit(along.radians());
  std::vector<Chain> chains;
  for (const Swath& swath : swaths) {  // in strip order, so a chain's last piece is known before the next
    Chain* home = nullptr;
    if (const Swath* before = only_neighbour(swath, swaths, axis, false);
        before != nullptr && only_neighbour(*before, swaths, axis, true) == &swath)
      for (Chain& chain : chains)
        if (chain.back() == before) home = &chain;
    if (home != nullptr)
      home->push_back(&swath);
    else
      chains.push_back({&swath});
  }
  return chains;
}

}  // namespace selion
