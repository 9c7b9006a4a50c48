// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for every field: a plan hangs on the field's shape, not on how or where it is written down.
#include "test.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "field_samples.hpp"
#include "generated_fields.hpp"
#include "selion/field/frame.hpp"
#include "selion/layout/layout.hpp"
#include "selion/plan/plan.hpp"

using namespace selion;

namespace {

constexpr int kOfEach = 5;
const LonLat kOrigin{10, 50};

struct Line {
  Point from;
  Point to;
};

/// What is compared of a plan, in metres around the place where the field was put.
struct Outcome {
  double area_m2 = 0;
  double covered_m2 = 0;
  int swaths = 0;
  int headland_passes = 0;
  std::vector<Line> swath_lines;
  std::vector<Line> pocket_lines;
};

/// What may differ, beside rounding.
struct Tolerance {
  double line_m = 0.01;         ///< an end of a swath
  double covered_share = 1e-4;  ///< of the field's area
  bool pockets = true;          ///< whether they are compared
};

Field field_at(const Polygon& area, const LocalFrame& frame) {
  const auto ring = [&frame](const Ring& corners) {
    LonLatRing result;
    for (const Point p : corners) result.push_back(frame.to_lonlat(p));
    return result;
  };
  LonLatPolygon part{ring(area.shell), {}};
  for (const Ring& hole : area.holes) part.holes.push_back(ring(hole));
  Field field;
  field.name = "generated";
  field.source = "generated";
  field.parts.push_back(part);
  return field;
}

Outcome outcome_at(const Polygon& area, const LocalFrame& frame, const Job& job) {
  const auto planned = plan(field_at(area, frame), job, Repair::notes_only, no_progress);
  Outcome outcome;
  if (!planned) {
    FAIL("not planned: " << planned.error().reason);
    return outcome;
  }
  for (const BlockReport& block : planned->blocks) {
    outcome.area_m2 += block.area_m2;
    outcome.covered_m2 += block.covered_m2;
    outcome.swaths += block.swaths;
    outcome.headland_passes += block.headland_passes;
  }
  for (const SwathRecord& swath : planned->file.swaths)
    (swath.id.starts_with('P') ? outcome.pocket_lines : outcome.swath_lines)
        .push_back({frame.to_local(swath.line.front()), frame.to_local(swath.line.back())});
  return outcome;
}

Outcome outcome_of(const Polygon& area) {
  static const LocalFrame frame = LocalFrame::centred(kOrigin);
  return outcome_at(area, frame, {});
}

struct Sample {
  GeneratedField field;
  Outcome outcome;
};

/// Each field planned once, for all that compare with it.
const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = [] {
    std::vector<Sample> made;
    for (GeneratedField& field : generated_fields(kOfEach)) {
      const Outcome outcome = outcome_of(field.area);
      made.push_back({std::move(field), outcome});
    }
    return made;
  }();
  return all;
}

double apart_m(const Line& a, const Line& b) {
  return std::min(std::max(distance_m(a.from, b.from), distance_m(a.to, b.to)),
                  std::max(distance_m(a.from, b.to), distance_m(a.to, b.from)));
}

/// The largest distance of a line of `a` to the nearest of `b`.
double farthest_m(const std::vector<Line>& a, const std::vector<Line>& b) {
  double farthest = 0;
  for (const Line& line : a) {
    double nearest = 1e9;
    for (const Line& other : b) nearest = std::min(nearest, apart_m(line, other));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

template <class Move>
void check_lines(const std::vector<Line>& lines, const std::vector<Line>& before, const Move& move,
                 double off_m) {
  std::vector<Line> expected;
  for (const Line& line : before) expected.push_back({move(line.from), move(line.to)});
  CHECK(lines.size() == expected.size());
  CHECK(farthest_m(lines, expected) < off_m);
  CHECK(farthest_m(expected, lines) < off_m);
}

/// `outcome` is that of the sample put through `move`.
template <class Move>
void check_same(const Sample& sample, const Outcome& outcome, const Move& move, const Tolerance& tolerance) {
  CAPTURE(sample.field.name);
  CHECK(outcome.area_m2 == Approx(sample.outcome.area_m2).epsilon(1e-6));
  CHECK(outcome.swaths == sample.outcome.swaths);
  CHECK(outcome.headland_passes == sample.outcome.headland_passes);
  check_lines(outcome.swath_lines, sample.outcome.swath_lines, move, tolerance.line_m);
  if (tolerance.pockets)
    check_lines(outcome.pocket_lines, sample.outcome.pocket_lines, move, tolerance.line_m);
  CHECK(std::abs(outcome.covered_m2 - sample.outcome.covered_m2) <
        tolerance.covered_share * sample.outcome.area_m2);
}

std::vector<Line> lines_of(const std::vector<Swath>& swaths) {
  std::vector<Line> lines;
  for (const Swath& swath : swaths) lines.push_back({swath.from, swath.to});
  return lines;
}

Point unmoved(Point p) { return p; }

}  // namespace

TEST_CASE("the generated fields are of the sizes that they are meant to have", "[property]") {
  for (const GeneratedField& field : generated_fields(kOfEach)) {
    CAPTURE(field.name);
    CHECK(fault(field.area).empty());
    CHECK(area_m2(field.area) > 0.6e4);
    CHECK(area_m2(field.area) < 5e4);
  }
}

TEST_CASE("a field that is turned and moved has its plan turned and moved", "[property]") {
  int i = 0;
  for (const Sample& sample : samples()) {
    const RigidMotion motion{0.4 + 0.37 * ++i, {150.0 * (i % 3 - 1), 80.0 * (i % 4 - 1)}};
    CAPTURE(motion.angle_rad);
    check_same(sample, outcome_of(moved(sample.field.area, motion)), motion, {});
  }
}

TEST_CASE("it does not matter at which corner the rings begin", "[property]") {
  for (const Sample& sample : samples()) {
    Polygon area = sample.field.area;
    std::rotate(area.shell.begin(), area.shell.begin() + 2, area.shell.end());
    for (Ring& hole : area.holes) std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    check_same(sample, outcome_of(area), unmoved, {});
  }
}

TEST_CASE("it does not matter which way round the rings are written", "[property]") {
  for (const Sample& sample : samples()) {
    Polygon area = sample.field.area;
    std::reverse(area.shell.begin(), area.shell.end());
    for (Ring& hole : area.holes) std::reverse(hole.begin(), hole.end());
    check_same(sample, outcome_of(area), unmoved, {});
  }
}

TEST_CASE("corners put on straight sides change nothing", "[property]") {
  const auto refined = [](const Ring& ring) {
    Ring result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point next = ring[(i + 1) % ring.size()];
      for (const double along : {0.0, 0.31, 0.5, 0.83}) result.push_back(ring[i] + along * (next - ring[i]));
    }
    return result;
  };
  for (const Sample& sample : samples()) {
    Polygon area{refined(sample.field.area.shell), {}};
    for (const Ring& hole : sample.field.area.holes) area.holes.push_back(refined(hole));
    check_same(sample, outcome_of(area), unmoved, {});
  }
}

TEST_CASE("a field a thousand kilometres off has the same plan there", "[property]") {
  // 9 degrees of latitude, and of longitude some more: each place has a frame of its own
  for (const LonLat origin : {LonLat{10, 59}, LonLat{24, 50}, LonLat{-60, -50}}) {
    const LocalFrame frame = LocalFrame::centred(origin);
    for (std::size_t i = 0; i < samples().size(); i += 3)
      check_same(samples()[i], outcome_at(samples()[i].field.area, frame, {}), unmoved, {});
  }
}

TEST_CASE("a block a thousand kilometres from its frame's origin has the same swaths", "[property]") {
  const RigidMotion away{0, {1e6, -1e6}};
  const auto lay_out = layouts().front().lay_out;
  for (const Sample& sample : samples()) {
    CAPTURE(sample.field.name);
    Block near;
    near.area = near.free = sample.field.area;
    Block far;
    far.area = far.free = moved(near.area, away);
    LayoutOptions options;
    options.along = best_edge_direction(near.area);

    const auto here = lay_out(near, {}, options);
    const auto there = lay_out(far, {}, options);

    REQUIRE(here.has_value());
    REQUIRE(there.has_value());
    CHECK(best_edge_direction(far.area).radians() == Approx(options.along.radians()).margin(1e-9));
    check_lines(lines_of(there->swaths), lines_of(here->swaths), away, 1e-3);
    check_lines(lines_of(there->pockets), lines_of(here->pockets), away, 1e-3);
  }
}

TEST_CASE("a mirrored field has a mirrored plan", "[property]") {
  const auto mirror = [](Point p) { return Point{-p.x_m, p.y_m}; };
  // The clearance around a hole is drawn as chords within 1 mm, from one end of an arc to the other, and the
  // headland's mitred corners on them amplify that: where a swath grazes one its end is up to 5 cm apart.
  // Headland passes go round the same way in both, so their corners leave other ground. What a rounded corner
  // leaves is like itself about its bisector: the pocket piece in it may lie along either side.
  for (const Sample& sample : samples()) {
    const Tolerance tolerance{
        .line_m = sample.field.area.holes.empty() ? 0.01 : 0.05, .covered_share = 3e-4, .pockets = false};
    check_same(sample, outcome_of(moved(sample.field.area, mirror)), mirror, tolerance);
  }
}

TEST_CASE("one hole more never raises the covered area", "[property]") {
  for (const Sample& sample : samples()) {
    for (const double radius_m : {0.6, 9.0}) {
      Polygon area = sample.field.area;
      const Point inside = deepest_place(area);
      Ring hole;
      for (int k = 0; k < 6; ++k) hole.push_back(inside + radius_m * unit(-std::numbers::pi * k / 3));
      area.holes.push_back(hole);
      CAPTURE(sample.field.name, radius_m);
      CHECK(outcome_of(area).covered_m2 <= sample.outcome.covered_m2 + 1e-6 * sample.outcome.area_m2);
    }
  }
}

TEST_CASE("a wider machine never needs more swaths", "[property]") {
  for (const Sample& sample : samples()) {
    int before = std::numeric_limits<int>::max();
    for (const double width_m : {2.0, 3.0, 4.0, 6.0}) {
      Job job;
      job.machine.working_width_m = width_m;
      job.machine.body_width_m = 1.9;
      const int swaths = outcome_at(sample.field.area, LocalFrame::centred(kOrigin), job).swaths;
      CAPTURE(sample.field.name, width_m);
      CHECK(swaths <= before);
      before = swaths;
    }
  }
}
