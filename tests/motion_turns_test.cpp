// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "selion/core/angle.hpp"
#include "selion/motion/dubins.hpp"
#include "selion/motion/turns.hpp"

using namespace selion;

namespace {

constexpr double kPi = std::numbers::pi;
// The limits of Cariou et al. 2020 as the U-turn figures use them; a machine that steers slowly; one that
// never reaches its curvature limit.
constexpr CurveLimits kPaper{0.27, 0.65};
constexpr auto kLimits = std::to_array<CurveLimits>({kPaper, {0.556, 0.436}, {0.15, 0.02}, {2, 0.3}});

struct Pair {
  Pose from;
  Pose to;
};

/// Pairs at distances from a micrometre to 100 m, with equal, opposite and any headings, and equal places
/// among them.
std::vector<Pair> pairs(int count) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> any{-1, 1};
  std::vector<Pair> all;
  for (int i = 0; i < count; ++i) {
    const double reach = std::pow(10, 8 * std::abs(any(random)) - 6);
    const Pose from{{300 * any(random), 300 * any(random)}, 7 * any(random)};
    Pose to{from.at + reach * Point{any(random), any(random)}, 7 * any(random)};
    if (i % 10 == 0) to.heading_rad = from.heading_rad;
    if (i % 10 == 1) to.heading_rad = from.heading_rad + kPi;
    if (i % 10 == 2) to.at = from.at + reach * unit(from.heading_rad);
    if (i % 50 == 3 || i % 50 == 20 || i % 50 == 31) to.at = from.at;
    all.push_back({from, to});
  }
  return all;
}

double heading_gap(double a, double b) { return std::abs(wrapped(a - b)); }

bool is_sound(const Path& path, const Pair& pair, const CurveLimits& limits) {
  const Gaps gap = gaps(path);
  if (gap.position_m > 1e-9 || gap.heading_rad > 1e-9 || gap.curvature_per_m > 1e-9) return false;
  if (distance_m(start_pose(path).at, pair.from.at) > 1e-9 ||
      distance_m(end_pose(path).at, pair.to.at) > 1e-9)
    return false;
  if (heading_gap(start_pose(path).heading_rad, pair.from.heading_rad) > 1e-9) return false;
  if (heading_gap(end_pose(path).heading_rad, pair.to.heading_rad) > 1e-9) return false;
  if (path.front().curve.curvature_per_m != 0 || std::abs(end_of(path.back().curve).curvature_per_m) > 1e-9)
    return false;
  return std::all_of(path.begin(), path.end(), [&](const Stretch& stretch) {
    const double end = end_of(stretch.curve).curvature_per_m;
    return std::abs(stretch.curve.curvature_per_m) <= limits.curvature_per_m * (1 + 1e-9) &&
           std::abs(end) <= limits.curvature_per_m * (1 + 1e-9) &&
           std::abs(stretch.curve.sharpness_per_m2) <= limits.sharpness_per_m2 * (1 + 1e-9);
  });
}

/// Shortest path of arcs of 1/K and straights (Dubins 1957; the formulas of Shkel and Lumelsky 2001).
double dubins_m(const Pair& pair, double curvature_per_m) {
  const Point way = pair.to.at - pair.from.at;
  const double d = length_m(way) * curvature_per_m;
  const double towards = length_m(way) > 0 ? heading_rad(way) : 0;
  const auto turn = [](double angle) {
    const double rest = std::fmod(angle, 2 * kPi);
    const double positive = rest < 0 ? rest + 2 * kPi : rest;
    return positive > 2 * kPi - 1e-9 ? 0 : positive;  // rounding below 0 is no whole turn
  };
  const double a = turn(pair.from.heading_rad - towards);
  const double b = turn(pair.to.heading_rad - towards);
  const double sa = std::sin(a), sb = std::sin(b), ca = std::cos(a), cb = std::cos(b), cab = std::cos(a - b);
  double best = 1e300;
  const auto consider = [&best](double t, double p, double q) { best = std::min(best, t + p + q); };
  if (const double p2 = 2 + d * d - 2 * cab + 2 * d * (sa - sb); p2 >= 0) {
    const double at = std::atan2(cb - ca, d + sa - sb);
    consider(turn(at - a), std::sqrt(p2), turn(b - at));
  }
  if (const double p2 = 2 + d * d - 2 * cab + 2 * d * (sb - sa); p2 >= 0) {
    const double at = std::atan2(ca - cb, d - sa + sb);
    consider(turn(a - at), std::sqrt(p2), turn(at - b));
  }
  if (const double p2 = -2 + d * d + 2 * cab + 2 * d * (sa + sb); p2 >= 0) {
    const double p = std::sqrt(p2);
    const double at = std::atan2(-ca - cb, d + sa + sb) - std::atan2(-2.0, p);
    consider(turn(at - a), p, turn(at - b));
  }
  if (const double p2 = -2 + d * d + 2 * cab - 2 * d * (sa + sb); p2 >= 0) {
    const double p = std::sqrt(p2);
    const double at = std::atan2(ca + cb, d - sa - sb) - std::atan2(2.0, p);
    consider(turn(a - at), p, turn(b - at));
  }
  for (const double side : {1.0, -1.0}) {
    const double cosine = (6 - d * d + 2 * cab + side * 2 * d * (sa - sb)) / 8;
    if (std::abs(cosine) > 1) continue;
    const double p = turn(2 * kPi - std::acos(cosine));
    const double at = std::atan2(side * (ca - cb), d - side * (sa - sb));
    const double t = side > 0 ? turn(a - at + p / 2) : turn(-a + std::atan2(-ca + cb, d + sa - sb) + p / 2);
    const double q = side > 0 ? turn(a - b - t + p) : turn(turn(b) - a - t + turn(p));
    consider(t, p, q);
  }
  return best / curvature_per_m;
}

Pose mirrored(const Pose& pose) { return {{pose.at.x_m, -pose.at.y_m}, -pose.heading_rad}; }

std::vector<double> lengths(const std::vector<Path>& paths) {
  std::vector<double> all;
  for (const Path& path : paths) all.push_back(length_m(path));
  std::sort(all.begin(), all.end());
  return all;
}

double shortest_m(std::string_view kind, double aside_m) {
  for (const TurnKind& turn : turns()) {
    if (turn.name != kind) continue;
    const auto all =
        lengths(turn.candidates({{5, -7}, 0.4}, {placed({{5, -7}, 0.4}, {0, aside_m}), 0.4 + kPi}, kPaper));
    return all.empty() ? -1 : all.front();
  }
  return -2;
}

}  // namespace

TEST_CASE("every candidate of every family meets the poses and keeps the limits", "[motion][turns]") {
  const auto& kind = GENERATE(from_range(turns().begin(), turns().end()));
  const auto& limits = GENERATE(from_range(kLimits.begin(), kLimits.end()));
  CAPTURE(kind.name, limits.curvature_per_m);
  int offered = 0;
  int wrong = 0;
  for (const Pair& pair : pairs(400)) {
    for (const Path& path : kind.candidates(pair.from, pair.to, limits)) {
      ++offered;
      wrong += is_sound(path, pair, limits) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(offered > 0);
}

TEST_CASE("any two poses are connected, shortest first, never shorter than Dubins", "[motion][turns]") {
  const auto& limits = GENERATE(from_range(kLimits.begin(), kLimits.end()));
  CAPTURE(limits.curvature_per_m);
  for (const Pair& pair : pairs(3000)) {
    CAPTURE(pair.from.at.x_m, pair.from.at.y_m, pair.from.heading_rad, pair.to.at.x_m, pair.to.at.y_m,
            pair.to.heading_rad);
    const auto all = connections(pair.from, pair.to, limits);
    REQUIRE_FALSE(all.empty());
    for (const Path& path : all) REQUIRE(is_sound(path, pair, limits));
    for (std::size_t i = 1; i < all.size(); ++i) REQUIRE(length_m(all[i - 1]) <= length_m(all[i]));
    REQUIRE(length_m(all.front()) >= dubins_m(pair, limits.curvature_per_m) - 1e-6);
  }
}

TEST_CASE("the length of Dubins' curve agrees with another derivation", "[motion][dubins]") {
  for (const Pair& pair : pairs(5000)) {
    CAPTURE(pair.from.at.x_m, pair.from.at.y_m, pair.from.heading_rad, pair.to.at.x_m, pair.to.at.y_m,
            pair.to.heading_rad);
    REQUIRE(dubins_length_m(pair.from, pair.to, 1 / 0.27) == Approx(dubins_m(pair, 0.27)).epsilon(1e-9));
  }
  CHECK(dubins_length_m({{0, 0}, 0.3}, {{0, 0}, 0.3}, 2) == Approx(0).margin(1e-9));
  CHECK(dubins_length_m({{1, 2}, 0.3}, {Point{1, 2} + 5 * unit(0.3), 0.3}, 2) == Approx(5));
}

TEST_CASE("mirrored poses give mirrored paths", "[motion][turns]") {
  for (const Pair& pair : pairs(300)) {
    const auto all = lengths(connections(pair.from, pair.to, kPaper));
    const auto other = lengths(connections(mirrored(pair.from), mirrored(pair.to), kPaper));
    CAPTURE(pair.to.at.x_m, pair.to.at.y_m, pair.to.heading_rad);
    CHECK(all.front() == Approx(other.front()).epsilon(1e-9));
  }
}

TEST_CASE("U-turns have the lengths of their closed forms", "[motion][turns]") {
  // K = .27/m, g = .65/m2: the figures of the omega, and 12.63967 + (w - 8) where there is a straight.
  for (const double side : {1.0, -1.0}) {
    CHECK(shortest_m("loop", 2 * side) == Approx(25.15106).margin(1e-5));
    CHECK(shortest_m("loop", 6 * side) == Approx(18.61870).margin(1e-5));
    for (const double w : {7.83, 8.0, 12.0})
      CHECK(shortest_m("flat", w * side) == Approx(12.63967 + w - 8).margin(1e-5));
  }
}

TEST_CASE("the dip fills the gap between the loop and the flat turn", "[motion][turns]") {
  // 2 b = 7.41 and 2 (a + b) = 7.83: narrower ones must loop, wider ones have a straight.
  CHECK(shortest_m("dip", 7.2) == -1);
  CHECK(shortest_m("flat", 7.8) == -1);
  CHECK(shortest_m("dip", 7.9) == -1);
  for (const double w : {7.45, 7.5, 7.7, 7.8}) {
    CAPTURE(w);
    CHECK(shortest_m("dip", w) > 0);
    CHECK(shortest_m("dip", w) == Approx(12.64 + w - 8).margin(0.02));
  }
}

TEST_CASE("a U-turn between swaths that end apart drives the shorter one on", "[motion][turns]") {
  for (const double ahead : {5.0, -5.0}) {
    for (const double aside : {2.0, 7.5, 9.0}) {
      const auto all = connections({{0, 0}, 0}, {{ahead, aside}, kPi}, kPaper);
      const auto even = connections({{0, 0}, 0}, {{0, aside}, kPi}, kPaper);
      CHECK(length_m(all.front()) <= length_m(even.front()) + 5 + 1e-9);
    }
  }
}

TEST_CASE("headings not quite opposite are met exactly", "[motion][turns]") {
  for (const double off : {1e-12, 1e-9, 5e-7, -5e-7}) {
    for (const auto& [name, aside] :
         {std::pair{"loop", 3.0}, std::pair{"dip", 7.5}, std::pair{"flat", 9.0}}) {
      const Pair pair{{{1, 2}, 0.3}, {placed({{1, 2}, 0.3}, {1, aside}), 0.3 + kPi + off}};
      for (const TurnKind& kind : turns()) {
        if (kind.name != name) continue;
        const auto all = kind.candidates(pair.from, pair.to, kPaper);
        CAPTURE(name, off);
        REQUIRE_FALSE(all.empty());
        CHECK(is_sound(all.front(), pair, kPaper));
      }
    }
  }
}

TEST_CASE("a swing turns by its deflection, from straight to straight, within the limits",
          "[motion][swing]") {
  const auto& limits = GENERATE(from_range(kLimits.begin(), kLimits.end()));
  const Pose from{{3, 4}, 1};
  CHECK(swing(from, 0, limits).empty());
  for (const double size : {1e-12, 1e-9, 1e-6, 1e-3, 0.05, 0.1121, 0.5, 1.5, 3.0, 4.5, 6.28}) {
    for (const double deflection : {size, -size}) {
      CAPTURE(deflection, limits.curvature_per_m);
      const Path path = swing(from, deflection, limits);
      const Pair pair{from, end_pose(path)};
      CHECK(is_sound(path, pair, limits));
      CHECK(std::abs(pair.to.heading_rad - from.heading_rad - deflection) <
            1e-15 * (1 + std::abs(deflection)) + 1e-15);
      const double peak = std::abs(path.back().curve.curvature_per_m);
      CHECK(peak == Approx(std::min(limits.curvature_per_m, std::sqrt(limits.sharpness_per_m2 * size))));
    }
  }
}

TEST_CASE("the corner of a swing is where its tangents meet", "[motion][swing]") {
  for (const double deflection : {1e-6, 0.05, 0.3, 1.0, 2.0, 3.0, -1.2}) {
    const Path path = swing({{0, 0}, 0}, deflection, kPaper);
    const Corner corner = corner_of(deflection, kPaper);
    CAPTURE(deflection);
    const Point end = end_pose(path).at;
    const Point expected = Point{corner.tangent_m, 0} + corner.tangent_m * unit(deflection);
    CHECK(distance_m(end, expected) < 1e-12);
    double nearest = 1e300;
    for (const Pose& pose : poses(path, length_m(path) / 2000)) {
      nearest = std::min(nearest, distance_m(pose.at, {corner.tangent_m, 0}));
    }
    CHECK(nearest == Approx(corner.cut_m).epsilon(1e-5));
  }
}

TEST_CASE("a turn at lower speed may be sharper", "[motion][swing]") {
  const Machine machine;
  CHECK(limits_at(machine, 1).curvature_per_m == limits_at(machine, 2).curvature_per_m);
  CHECK(limits_at(machine, 1).sharpness_per_m2 ==
        Approx(2 * limits_at(machine, 2).sharpness_per_m2).epsilon(1e-4));
}

TEST_CASE("near poses are connected by the shortest three swings there are", "[motion][turns]") {
  // Lengths of the best of 288 Newton runs each, from all over the two free deflections; in all of them an
  // outer swing is small, where its length goes by the square root of its deflection and roots are missed
  // most easily.
  struct Known {
    CurveLimits limits;
    Pose goal;
    double length_m;
  };
  for (const Known& known : {Known{kPaper, {{2.9121, 0.0016}, 1.6609}, 25.4264},
                             {kPaper, {{-1.2585, -0.3001}, -1.1448}, 22.4711},
                             {{0.556, 0.436}, {{-0.6054, 6.8151}, 1.294}, 10.8954},
                             {{0.556, 0.436}, {{0.0501, 0.0546}, 1.0031}, 11.5802},
                             {{0.15, 0.02}, {{24.0986, -12.6025}, 1.4614}, 48.0966},
                             {{0.15, 0.02}, {{5.5556, 2.9426}, 0.9747}, 49.7211}}) {
    CAPTURE(known.goal.at.x_m, known.goal.at.y_m);
    CHECK(length_m(connections({}, known.goal, known.limits).front()) <= known.length_m + 0.005);
  }
}
