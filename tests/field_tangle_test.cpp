// SPDX-License-Identifier: GPL-3.0-or-later
#include "test.hpp"

#include <cmath>
#include <random>
#include <set>

#include "field/tangle.hpp"
#include "field_samples.hpp"

using namespace selion;

namespace {

/// What a receiver writes that stands there.
Ring jitter(Point at, int corners, double by_m) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> off{-by_m, by_m};
  Ring ring;
  while (static_cast<int>(ring.size()) < corners) ring.push_back(at + Point{off(random), off(random)});
  return ring;
}

/// A strip whose eastern side has slanted teeth, as deep as the strip is long.
Ring comb(int teeth) {
  Ring ring{{500, 500}, {0, 500}, {0, 0}};
  for (int k = 0; k < teeth; ++k) {
    ring.push_back({500 + 500.0 * k / teeth, 500.0 * k / teeth});
    ring.push_back({50 + 500.0 * k / teeth, -500 + 500.0 * (k + 0.5) / teeth});
  }
  return ring;
}

std::string refused(const Ring& ring) {
  const Field field = field_of_metres({{ring, {}}});
  BlockOptions options;
  options.repair = Repair::accept;
  return error_of([&] { blocks_of(field, LocalFrame::centred(centre(field)), options); });
}

}  // namespace

TEST_CASE("near edges are those whose boxes meet, each pair once", "[field][tangle]") {
  const Ring ring = jitter({}, 300, 100);
  const auto meet = [&](std::size_t i, std::size_t k) {
    const auto along = [&](auto coordinate) {
      const auto [a, b] = std::minmax({coordinate(ring[i]), coordinate(ring[(i + 1) % ring.size()])});
      const auto [c, d] = std::minmax({coordinate(ring[k]), coordinate(ring[(k + 1) % ring.size()])});
      return a <= d && c <= b;
    };
    return along([](Point p) { return p.x_m; }) && along([](Point p) { return p.y_m; });
  };
  std::set<std::pair<std::size_t, std::size_t>> expected;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t k = i + 1; k < ring.size(); ++k)
      if (meet(i, k)) expected.emplace(i, k);
  std::set<std::pair<std::size_t, std::size_t>> found;
  CHECK(NearEdges{ring}.each_pair([&](std::size_t i, std::size_t k) {
    CHECK(found.emplace(i, k).second);
    return true;
  }));
  CHECK(found == expected);
  CHECK(NearEdges{Ring{}}.each_pair([](std::size_t, std::size_t) { return false; }));
}

TEST_CASE("a scribble is no border, whatever may be repaired", "[field][tangle]") {
  for (const int corners : {200, 360, 3600}) {
    CAPTURE(corners);  // of two random sides, about a quarter cross: 5000 times, 16 000, 1.6 million
    Ring stood{{0, 0}, {200, 0}, {200, 200}};
    for (const Point p : jitter({0, 200}, corners, 0.2)) stood.push_back(p);
    const bool too_often = mentions(refused(stood), "crosses itself more than 10000 times near");
    CHECK(too_often == (corners > 200));
  }
  CHECK(mentions(refused(comb(800)), "pairs of its sides lie abreast"));
}

TEST_CASE("a border of many long teeth, or that was walked unsteadily, is one", "[field][tangle]") {
  CHECK(refused(comb(200)) == "");
  Ring walked;
  for (int k = 0; k < 4000; ++k) {
    const double angle = 2 * 3.14159265 * k / 4000;
    walked.push_back((150 + 0.2 * (k % 3)) * unit(angle));
  }
  CHECK(refused(walked) == "");
}
